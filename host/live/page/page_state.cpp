#include "live/page/page_state.h"

#include <cstring>
#include <iterator>
#include <utility>

namespace hyalite::live {

namespace {

constexpr std::size_t kMostPrints = 400;
constexpr std::size_t kMostNotes = 30;

InspectedPath failure(std::uint64_t request, const std::string& why) {
    return {.request = request, .error = why, .path = {}};
}

} // namespace

std::optional<Picture> pictureOf(PictureRendered rendered) {
    const PictureInfo& info = rendered.info;
    std::vector<std::string> names{"picture"};
    names.insert(names.end(), info.layers.begin(), info.layers.end());
    if (info.width <= 0 || info.height <= 0) {
        return std::nullopt;
    }
    const std::size_t layerBytes =
        static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.height) * sizeof(glm::vec3);
    if (rendered.pixels.size() != names.size() * layerBytes) {
        return std::nullopt;
    }
    Picture picture;
    for (std::size_t i = 0; i < names.size(); ++i) {
        Image image(info.width, info.height);
        std::memcpy(image.pixels.data(), rendered.pixels.data() + i * layerBytes, layerBytes);
        picture.layers.push_back({names[i], std::move(image)});
    }
    picture.info = std::move(rendered.info);
    return picture;
}

PageState::PageState(std::string sceneName, std::map<std::string, std::string> settings, LiveFiles files)
    : sceneName_(std::move(sceneName)), startSettings_(std::move(settings)),
      files_(std::make_shared<const LiveFiles>(std::move(files))) {
    wanted_.revision = 1;
    wanted_.change = 1;
    wanted_.settings = startSettings_;
}

void PageState::touch() {
    ++version_;
    changed_.notify_all();
}

void PageState::close() {
    const std::scoped_lock lock(mutex_);
    isClosing_ = true;
    touch();
}

StateAnswer PageState::state(std::uint64_t seen, std::chrono::milliseconds patience) {
    StateAnswer answer;
    std::vector<ErrorReport> stops;
    std::shared_ptr<const LiveFiles> files;
    {
        std::unique_lock lock(mutex_);
        if (waiting_ < kMostWaiting) {
            ++waiting_;
            changed_.wait_for(lock, patience, [&] { return version_ != seen || isClosing_; });
            --waiting_;
        }
        answer.version = version_;
        answer.revision = wanted_.revision;
        answer.scene = scene_;
        answer.overrides = wanted_.settings;
        answer.shown = wanted_.shown;
        answer.picture = picture_ ? std::optional(picture_->info) : std::nullopt;
        answer.errors = errors_;
        answer.prints = prints_;
        answer.printCount = printCount_;
        answer.notes = notes_;
        answer.firstPixelSeconds = firstPixelSeconds_;
        answer.reloadSeconds = reloadSeconds_;
        answer.changes = wanted_.change;
        answer.isBusy = workerIsWanted_ && finishedAfter_ != wanted_.change;
        answer.isClosing = isClosing_;
        stops = stops_;
        files = files_;
    }
    answer.name = sceneName_;
    std::ranges::move(stops, std::back_inserter(answer.errors));
    for (ErrorReport& error : answer.errors) {
        error.name = files->nameOf(error.file);
    }
    return answer;
}

std::shared_ptr<const Picture> PageState::picture() const {
    const std::scoped_lock lock(mutex_);
    return picture_;
}

std::shared_ptr<const LiveFiles> PageState::files() const {
    const std::scoped_lock lock(mutex_);
    return files_;
}

void PageState::change(const ChangeRequest& request) {
    const std::scoped_lock lock(mutex_);
    if (request.reset) {
        wanted_.settings = startSettings_;
    }
    for (const auto& [key, value] : request.settings) {
        if (value) {
            wanted_.settings[key] = *value;
        } else {
            wanted_.settings.erase(key);
        }
    }
    wanted_.shown = request.shown.value_or(wanted_.shown);
    wanted_.pixel = request.pixel.value_or(wanted_.pixel);
    ++wanted_.revision;
    ++wanted_.change;
    revisedAt_ = Clock::now();
    workerIsWanted_ = true;
    touch();
}

void PageState::choosePixel(std::uint32_t pixel) {
    const std::scoped_lock lock(mutex_);
    wanted_.pixel = pixel;
    ++wanted_.change;
    touch();
}

std::uint64_t PageState::beginInspection() {
    const std::scoped_lock lock(mutex_);
    path_.reset();
    changed_.notify_all(); // the request before this one
    return ++inspection_;
}

InspectedPath PageState::awaitInspection(std::uint64_t request, std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [&] { return path_ || inspection_ != request || isClosing_; });
    if (inspection_ != request) {
        return failure(request, "another pixel was asked for meanwhile");
    }
    return path_ ? *path_ : failure(request, "the worker did not answer in time");
}

void PageState::answer(InspectedPath path) {
    const std::scoped_lock lock(mutex_);
    if (path.request == inspection_) {
        path_ = std::move(path);
        touch();
    }
}

void PageState::failInspection(const std::string& why) {
    const std::scoped_lock lock(mutex_);
    if (inspection_ > 0 && !path_) {
        path_ = failure(inspection_, why);
        touch();
    }
}

Look PageState::look() const {
    const std::scoped_lock lock(mutex_);
    return wanted_;
}

std::uint64_t PageState::filesChanged() {
    const std::scoped_lock lock(mutex_);
    savedAt_ = Clock::now();
    ++wanted_.change;
    touch();
    return wanted_.change;
}

void PageState::workerStarts() {
    const std::scoped_lock lock(mutex_);
    finishedAfter_.reset();
    touch();
}

void PageState::setWorkerWanted(bool wanted) {
    const std::scoped_lock lock(mutex_);
    if (workerIsWanted_ != wanted) {
        workerIsWanted_ = wanted;
        touch();
    }
}

void PageState::finished(const WorkDone& done) {
    const std::scoped_lock lock(mutex_);
    finishedAfter_ = done.change;
    touch();
}

bool PageState::show(PictureRendered rendered) {
    std::optional<Picture> picture = pictureOf(std::move(rendered));
    if (!picture) {
        return false;
    }
    const auto now = Clock::now();
    const auto since = [&](Clock::time_point time) { return std::chrono::duration<double>(now - time).count(); };
    const std::scoped_lock lock(mutex_);
    touch();
    picture->info.id = version_;
    const std::uint32_t revision = picture->info.revision;
    if (revision != seenRevision_ && revision == wanted_.revision) {
        firstPixelSeconds_ = since(revisedAt_);
        seenRevision_ = revision;
    }
    if (savedAt_) {
        reloadSeconds_ = since(*savedAt_);
        savedAt_.reset();
    }
    picture_ = std::make_shared<const Picture>(*std::move(picture));
    return true;
}

void PageState::show(SceneInfo scene) {
    const auto files = std::make_shared<const LiveFiles>(this->files()->withCode(scene.code));
    const std::scoped_lock lock(mutex_);
    files_ = files;
    scene_ = std::move(scene);
    touch();
}

void PageState::showErrors(std::vector<ErrorReport> errors) {
    const std::scoped_lock lock(mutex_);
    errors_ = std::move(errors);
    touch();
}

void PageState::showStops(std::vector<ErrorReport> stops) {
    const std::scoped_lock lock(mutex_);
    stops_ = std::move(stops);
    touch();
}

void PageState::addPrints(const std::vector<std::string>& lines) {
    const std::scoped_lock lock(mutex_);
    prints_.insert(prints_.end(), lines.begin(), lines.end());
    printCount_ += lines.size();
    while (prints_.size() > kMostPrints) {
        prints_.pop_front();
    }
    touch();
}

void PageState::addNote(const std::string& line) {
    const std::scoped_lock lock(mutex_);
    notes_.push_back(line);
    if (notes_.size() > kMostNotes) {
        notes_.pop_front();
    }
    touch();
}

} // namespace hyalite::live
