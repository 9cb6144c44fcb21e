// What the page shows, and what it asked for. Every function may be called from any thread; the mutex guards the
// members alone: nothing waits for a file or a worker while it is held.
#pragma once

#include "image/layered_image.h"
#include "live/messages/page_messages.h"
#include "live/page/live_files.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace hyalite::live {

// The last picture that the worker sent.
struct Picture { // NOLINT(bugprone-exception-escape): no member throws when it is moved
    PictureInfo info;
    std::vector<NamedImage> layers; // the first is the picture itself, called "picture"
};

// Nothing when the number of bytes does not fit the layers and the size.
[[nodiscard]] std::optional<Picture> pictureOf(PictureRendered rendered);

class PageState {
public:
    // So many requests for the state wait for news at the same time; any more are answered at once, so that pages left
    // open never take all of the server's threads.
    static constexpr int kMostWaiting = 12;

    // `settings`: what the server was started with, over the scene file.
    PageState(std::string sceneName, std::map<std::string, std::string> settings, LiveFiles files);

    // ---- for the page ----

    // The state, as soon as its version differs from `seen`, or after `patience`.
    [[nodiscard]] StateAnswer state(std::uint64_t seen, std::chrono::milliseconds patience);
    [[nodiscard]] std::shared_ptr<const Picture> picture() const; // nullptr: none yet
    [[nodiscard]] std::shared_ptr<const LiveFiles> files() const;

    void change(const ChangeRequest& request);
    void choosePixel(std::uint32_t pixel); // without a new revision: see PixelChosen

    // A new request for a pixel's path; requests before it are answered with an error.
    [[nodiscard]] std::uint64_t beginInspection();
    // Waits for the answer to it.
    [[nodiscard]] InspectedPath awaitInspection(std::uint64_t request, std::chrono::milliseconds patience);

    // Wakes all who wait for a state or a path; nobody waits from now on.
    void close();

    // ---- for the supervisor ----

    [[nodiscard]] Look look() const; // what the page wants, and the number of the last change
    // Saved files are a change; returns its number.
    std::uint64_t filesChanged();
    void workerStarts();
    // Whether a worker runs or will.
    void setWorkerWanted(bool wanted);
    void finished(const WorkDone& done);
    // Returns whether there was a picture in it.
    bool show(PictureRendered rendered);
    void show(SceneInfo scene);
    void showErrors(std::vector<ErrorReport> errors);
    void showStops(std::vector<ErrorReport> stops); // see WorkerLife::stops
    void addPrints(const std::vector<std::string>& lines);
    void addNote(const std::string& line);
    void answer(InspectedPath path);
    // Answers the last request, if it is not answered yet.
    void failInspection(const std::string& why);

private:
    using Clock = std::chrono::steady_clock;

    void touch(); // a new version

    const std::string sceneName_;
    const std::map<std::string, std::string> startSettings_;

    mutable std::mutex mutex_; // of everything below
    std::condition_variable changed_;
    int waiting_ = 0; // requests that wait for news
    std::uint64_t version_ = 1;
    bool isClosing_ = false;

    // Its `change` counts changes of files, settings, view and pixel. The start is number 1: a worker that has not
    // received anything yet is done with number 0.
    Look wanted_;
    Clock::time_point revisedAt_ = Clock::now();
    std::optional<Clock::time_point> savedAt_; // the last saved file that no picture has followed yet
    bool workerIsWanted_ = true;
    std::optional<std::uint64_t> finishedAfter_; // the change after which the worker had nothing left to do

    std::shared_ptr<const LiveFiles> files_;
    std::shared_ptr<const Picture> picture_;
    std::optional<SceneInfo> scene_;
    std::vector<ErrorReport> errors_;
    std::vector<ErrorReport> stops_;
    std::deque<std::string> prints_;
    std::uint64_t printCount_ = 0;
    std::deque<std::string> notes_;
    double firstPixelSeconds_ = 0;
    double reloadSeconds_ = 0;
    std::uint32_t seenRevision_ = 0; // of the last picture

    std::uint64_t inspection_ = 0; // number of the last request
    std::optional<InspectedPath> path_;
};

} // namespace hyalite::live
