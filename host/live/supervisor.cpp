#include "live/supervisor.h"

#include "base/error.h"

#include <algorithm>
#include <cstring>

namespace hyalite::live {

namespace {

using namespace std::chrono_literals;

constexpr auto kBetweenLooks = 50ms;    // at the worker's pulse
constexpr auto kBetweenWatches = 100ms; // of files
constexpr std::size_t kMostPrints = 400;
constexpr std::size_t kMostNotes = 30;
constexpr int kMostFailures = 3;
// Loading a scene may take longer than any kernel; and the driver compiles a kernel when it runs first.
constexpr double kLimitOfLoading = 20;

} // namespace

Supervisor::Supervisor(SupervisorOptions options)
    : options_(std::move(options)), settings_(options_.settings), files_(options_.shaders, options_.scene) {
    shaderWatch_.watchFolder(options_.shaders);
    sceneWatch_.watchFiles({options_.scene.string()});
    thread_ = std::thread([this] { run(); });
}

Supervisor::~Supervisor() {
    close();
    thread_.join();
}

void Supervisor::close() {
    const std::scoped_lock lock(mutex_);
    isClosing_ = true;
    changed_.notify_all();
}

void Supervisor::touch() {
    ++version_;
    changed_.notify_all();
}

void Supervisor::note(const std::string& line) {
    notes_.push_back(line);
    if (notes_.size() > kMostNotes) {
        notes_.pop_front();
    }
    options_.say(line);
    touch();
}

void Supervisor::run() {
    while (true) {
        {
            std::unique_lock lock(mutex_);
            // Where workers end and end, only a change is a reason to try again
            while (!isClosing_ && !isWanted_) {
                changed_.wait_for(lock, kBetweenWatches);
                if (shaderWatch_.hasChanged() || sceneWatch_.hasChanged()) {
                    isWanted_ = true;
                    failures_ = 0;
                    ++changes_;
                }
            }
            if (isClosing_) {
                return;
            }
        }
        try {
            runWorker();
        } catch (const Error& error) {
            const std::scoped_lock lock(mutex_);
            note(error.what());
            isWanted_ = false;
        }
    }
}

void Supervisor::runWorker() {
    WorkerProcess worker(options_.workerArguments);
    {
        const std::scoped_lock lock(mutex_);
        worker_ = &worker;
        workerIsGone_ = false;
        running_.clear();
        restsAfter_.reset();
        worker.channel().send(
            {{"kind", "start"}, {"scene", options_.scene.string()}, {"good", versions_.good}, {"bad", versions_.bad}});
        tellChange(lookMessage());
    }
    std::thread reader([&] {
        while (std::optional<Message> message = worker.channel().receive()) {
            handle(*std::move(message));
        }
        const std::scoped_lock lock(mutex_);
        workerIsGone_ = true;
        changed_.notify_all();
    });
    watch(worker);
    worker.channel().close();
    reader.join();
    const std::scoped_lock lock(mutex_);
    worker_ = nullptr;
}

void Supervisor::watch(WorkerProcess& worker) {
    auto watchedAt = Clock::now();
    std::unique_lock lock(mutex_);
    while (!workerIsGone_ && !isClosing_) {
        changed_.wait_for(lock, kBetweenLooks, [&] { return workerIsGone_ || isClosing_; });
        const auto work = worker.pulse().look();
        const double limit = options_.limit * (work && !work->isKernel ? kLimitOfLoading : 1);
        if (work && work->seconds > limit) {
            worker.kill();
            lock.unlock();
            const std::string how = worker.wait();
            lock.lock();
            hasEnded(how, work, /*tookTooLong*/ true);
            return;
        }
        if (Clock::now() - watchedAt < kBetweenWatches) {
            continue;
        }
        watchedAt = Clock::now();
        const bool shaders = shaderWatch_.hasChanged();
        const bool scene = sceneWatch_.hasChanged();
        if (shaders || scene) {
            reloadedAt_ = watchedAt;
        }
        if (shaders) {
            tellChange({{"kind", "sources"}});
        }
        if (scene) {
            tellChange({{"kind", "scene"}});
        }
    }
    if (isClosing_) {
        worker.kill();
        return;
    }
    const auto work = worker.pulse().look();
    lock.unlock();
    const std::string how = worker.wait();
    lock.lock();
    hasEnded(how, work, /*tookTooLong*/ false);
}

std::set<std::string> Supervisor::unproven() const {
    std::set<std::string> names;
    for (const auto& [kernel, name] : running_) {
        const auto good = versions_.good.find(kernel);
        if (good == versions_.good.end() || good->second != name) {
            names.insert(kernel);
        }
    }
    return names;
}

void Supervisor::hasEnded(const std::string& how, const std::optional<Pulse::Work>& work, bool tookTooLong) {
    const bool inKernel = work && work->isKernel;
    std::string line = inKernel ? "kernel '" + work->name + "' " : "the worker ";
    if (!tookTooLong) {
        line += how;
    } else if (inKernel) {
        line += "did not end within " + std::to_string(static_cast<int>(options_.limit)) + " s and was stopped";
    } else {
        line += "was stopped: it has been " + work->name + " for too long";
    }
    // Who was new is to blame: the kernel that ran or, where that had proved good, all that were
    std::set<std::string> blamed = unproven();
    if (inKernel && blamed.contains(work->name)) {
        blamed = {work->name};
    }
    // Drivers hang too, once in a thousand hours: a kernel that has nothing to fall back on gets a second chance
    std::erase_if(blamed, [&](const std::string& kernel) {
        return !versions_.good.contains(kernel) && ++strikes_[running_.at(kernel)] < 2;
    });
    for (const std::string& kernel : blamed) {
        versions_.bad.insert(running_.at(kernel));
        const std::string goesOn = versions_.good.contains(kernel)
                                       ? "; its last good version goes on"
                                       : "; there is no earlier version of it to go on with";
        stops_[kernel] = {{"source", "worker"},
                          {"message", line + (inKernel ? goesOn : "")},
                          {"hint", "mend the kernel and save it"},
                          {"kernel", kernel},
                          {"file", (options_.shaders / "kernels" / (kernel + ".comp")).string()},
                          {"line", 0},
                          {"column", 0},
                          {"excerpt", Json::array()}};
    }
    failures_ = blamed.empty() ? failures_ + 1 : 0;
    isWanted_ = failures_ < kMostFailures;
    note(line + (isWanted_ ? "; a new worker takes over" : "; it has ended too often: change something to try again"));
}

void Supervisor::tellChange(Json message) {
    ++changes_;
    if (worker_ != nullptr) {
        message["change"] = changes_;
        worker_->channel().send(message);
    }
}

Json Supervisor::lookMessage() const {
    return {{"kind", "look"}, {"revision", revision_}, {"settings", settings_}, {"shown", shown_}, {"pixel", pixel_}};
}

void Supervisor::handle(Message message) {
    const std::scoped_lock lock(mutex_);
    const std::string kind = message.kind();
    if (kind == "picture") {
        takePicture(std::move(message));
    } else if (kind == "compiled") {
        running_[message.body.at("kernel")] = message.body.at("version");
    } else if (kind == "good") {
        versions_.good = message.body.at("versions").get<std::map<std::string, std::string>>();
    } else if (kind == "errors") {
        errors_ = message.body.at("list");
        // What was stopped is of interest as long as another version stands in for it
        const auto standIns = message.body.at("stand_ins").get<std::set<std::string>>();
        std::erase_if(stops_, [&](const auto& stop) {
            return versions_.good.contains(stop.first) && !standIns.contains(stop.first);
        });
    } else if (kind == "scene") {
        scene_ = std::move(message.body);
        auto files = scene_.at("files").get<std::vector<std::string>>();
        files.push_back(options_.scene.string());
        sceneWatch_.watchFiles(files);
        static_cast<void>(sceneWatch_.hasChanged());
        files_.setCode(scene_.at("code").get<std::vector<std::string>>());
    } else if (kind == "prints") {
        for (const auto& printed : message.body.at("lines")) {
            prints_.push_back(printed.get<std::string>());
            options_.say(prints_.back());
            ++printCount_;
        }
        if (const auto lost = message.body.value("lost", std::uint64_t{0}); lost > 0) {
            prints_.push_back("… and " + std::to_string(lost) + " more");
            options_.say(prints_.back());
        }
        while (prints_.size() > kMostPrints) {
            prints_.pop_front();
        }
    } else if (kind == "rest") {
        restsAfter_ = message.body.at("change").get<std::uint64_t>();
    } else if (kind == "path" && message.body.value("request", 0) == inspections_) {
        path_ = std::move(message.body);
    }
    touch();
}

void Supervisor::takePicture(Message message) {
    Json& about = message.body;
    const auto width = about.at("width").get<int>();
    const auto height = about.at("height").get<int>();
    auto picture = std::make_shared<Picture>();
    std::vector<std::string> names{"picture"};
    for (const auto& name : about.at("layers")) {
        names.push_back(name.get<std::string>());
    }
    const std::size_t layerBytes =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * sizeof(glm::vec3);
    if (width <= 0 || height <= 0 || message.bytes.size() != names.size() * layerBytes) {
        return;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        Image image(width, height);
        std::memcpy(image.pixels.data(), message.bytes.data() + i * layerBytes, layerBytes);
        picture->layers.push_back({names[i], std::move(image)});
    }
    const auto now = Clock::now();
    const auto seconds = [&](Clock::time_point since) { return std::chrono::duration<double>(now - since).count(); };
    const auto revision = about.value("revision", 0U);
    if (revision != seenRevision_ && revision == revision_) {
        firstPixelSeconds_ = seconds(revisedAt_);
        seenRevision_ = revision;
    }
    if (reloadedAt_) {
        reloadSeconds_ = seconds(*reloadedAt_);
        reloadedAt_.reset();
    }
    failures_ = 0;
    picture->about = std::move(about);
    picture->about["id"] = version_ + 1;
    picture_ = std::move(picture);
}

Json Supervisor::state(std::uint64_t seen, std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [&] { return version_ != seen || isClosing_; });
    Json errors = errors_;
    for (Json& error : errors) {
        error["name"] = files_.nameOf(error.value("file", std::string()));
    }
    for (const auto& [kernel, stop] : stops_) {
        Json error = stop;
        error["name"] = files_.nameOf(error.value("file", std::string()));
        errors.push_back(std::move(error));
    }
    return {{"version", version_},
            {"revision", revision_},
            {"name", options_.scene.filename().string()},
            {"scene", scene_},
            {"overrides", settings_},
            {"shown", shown_},
            {"picture", picture_ ? picture_->about : Json()},
            {"errors", std::move(errors)},
            {"prints", prints_},
            {"print_count", printCount_},
            {"notes", notes_},
            {"first_pixel_seconds", firstPixelSeconds_},
            {"reload_seconds", reloadSeconds_},
            {"changes", changes_},
            {"busy", isWanted_ && restsAfter_ != changes_},
            {"closing", isClosing_}};
}

std::shared_ptr<const Picture> Supervisor::picture() const {
    const std::scoped_lock lock(mutex_);
    return picture_;
}

void Supervisor::change(const Json& wanted) {
    const auto bad = [](const std::string& what) { throw Error(ExitCode::WrongUsage, what); };
    if (!wanted.is_object()) {
        bad("a change is a JSON object");
    }
    const std::scoped_lock lock(mutex_);
    if (wanted.size() == 1 && wanted.contains("pixel") && wanted["pixel"].is_number_unsigned()) {
        pixel_ = wanted["pixel"].get<std::uint32_t>();
        // A picture that does not depend on it goes on
        tellChange({{"kind", "pixel"}, {"pixel", pixel_}, {"matters", files_.anyShaderHas("debugPixel(")}});
        return;
    }
    auto settings = wanted.value("reset", false) ? options_.settings : settings_;
    if (const auto found = wanted.find("settings"); found != wanted.end()) {
        if (!found->is_object()) {
            bad("'settings' is a JSON object");
        }
        for (const auto& [key, value] : found->items()) {
            if (value.is_null()) {
                settings.erase(key);
            } else if (value.is_string()) {
                settings[key] = value.get<std::string>();
            } else {
                bad("values of 'settings' are texts, or null");
            }
        }
    }
    const Json shown = wanted.value("shown", Json(shown_));
    const Json pixel = wanted.value("pixel", Json(pixel_));
    if (!shown.is_string() || !pixel.is_number_unsigned()) {
        bad("'shown' is a text, 'pixel' a number");
    }
    settings_ = std::move(settings);
    shown_ = shown.get<std::string>();
    pixel_ = pixel.get<std::uint32_t>();
    ++revision_;
    revisedAt_ = Clock::now();
    failures_ = 0;
    isWanted_ = true;
    tellChange(lookMessage());
    touch();
}

Json Supervisor::inspect(std::uint32_t x, std::uint32_t y) {
    std::unique_lock lock(mutex_);
    const int request = ++inspections_;
    path_.reset();
    if (worker_ == nullptr) {
        return {{"error", "no worker runs"}};
    }
    worker_->channel().send({{"kind", "inspect"}, {"request", request}, {"x", x}, {"y", y}});
    changed_.wait_for(lock, 60s, [&] { return path_ || inspections_ != request || workerIsGone_ || isClosing_; });
    return path_ ? *path_ : Json{{"error", "the path did not come"}};
}

std::vector<std::string> Supervisor::fileNames() const {
    const std::scoped_lock lock(mutex_);
    return files_.names();
}

std::optional<std::filesystem::path> Supervisor::findFile(const std::string& name) const {
    const std::scoped_lock lock(mutex_);
    return files_.find(name);
}

} // namespace hyalite::live
