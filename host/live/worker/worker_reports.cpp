#include "live/worker/worker_reports.h"

#include "live/worker/scene_info.h"

#include <algorithm>
#include <span>
#include <utility>

namespace hyalite::live {

namespace {

constexpr auto kBetweenPictures = std::chrono::milliseconds(300);

// Appends the layers to the message, in the order in which it names them.
void addLayers(PictureRendered& message, const LayeredImage& image) {
    const auto add = [&](const Image& layer) {
        const auto pixels = std::as_bytes(std::span(layer.pixels));
        message.pixels.insert(message.pixels.end(), pixels.begin(), pixels.end());
    };
    add(image.picture);
    for (const NamedImage& layer : image.layers) {
        message.info.layers.push_back(layer.name);
        add(layer.image);
    }
    if (image.error) {
        message.info.layers.emplace_back("error");
        add(*image.error);
    }
}

} // namespace

void WorkerReports::done(std::uint64_t change) {
    if (doneAfter_ != change) {
        doneAfter_ = change;
        send(channel_, WorkDone{change});
    }
}

void WorkerReports::proved(const KernelVersions& versions) {
    if (versions.good != sentGood_) {
        sentGood_ = versions.good;
        send(channel_, KernelsProved{versions.good});
    }
}

void WorkerReports::errors(const StandingErrors& standing) {
    const std::map<std::string, Error> ofKernels = compiler_.errors();
    Errors message;
    if (standing.scene) {
        message.list.push_back(reportOf(*standing.scene, "scene"));
    }
    if (standing.setting) {
        message.list.push_back(reportOf(*standing.setting, "setting"));
    }
    for (const auto& [kernel, error] : ofKernels) {
        message.list.push_back(reportOf(error, "kernel"));
        message.list.back().kernel = kernel;
    }
    // A kernel that does not compile also fails the pass: one report of it is enough
    const bool isReported = standing.run && std::ranges::any_of(ofKernels, [&](const auto& entry) {
                                return entry.second.message() == standing.run->message();
                            });
    if (standing.run && !isReported) {
        message.list.push_back(reportOf(*standing.run, "kernel"));
    }
    message.standIns = compiler_.standIns();
    if (Json json = message; json != sentErrors_) {
        sentErrors_ = std::move(json);
        send(channel_, message);
    }
}

void WorkerReports::prints(DebugPrints::Prints prints) {
    if (!prints.lines.empty() || prints.lost > 0) {
        send(channel_, Prints{.lines = std::move(prints.lines), .lost = prints.lost});
    }
}

void WorkerReports::scene(const LiveRenderer& renderer) {
    send(channel_, sceneInfoOf(renderer.scene(), renderer.view()));
}

void WorkerReports::files(std::map<std::string, FileStamp> files) {
    if (files != sentFiles_) {
        sentFiles_ = std::move(files);
        send(channel_, FilesRead{sentFiles_});
    }
}

void WorkerReports::path(InspectedPath path) {
    send(channel_, path);
}

void WorkerReports::pictureOfPass(LiveRenderer& renderer, std::uint32_t revision) {
    if (!renderer.isPreview() && !renderer.isDone() && !isFirstOfSize_ &&
        Clock::now() - pictureAt_ <= kBetweenPictures) {
        return;
    }
    const LiveRenderer::Frame frame = renderer.frame();
    PictureRendered message{.info = pictureInfoOf(frame), .pixels = {}};
    message.info.revision = revision;
    addLayers(message, frame.image);
    send(channel_, message);
    pictureAt_ = Clock::now();
    isFirstOfSize_ = frame.isPreview;
}

} // namespace hyalite::live
