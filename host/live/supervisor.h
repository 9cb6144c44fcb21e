// The live picture as the server keeps it, and the worker that renders it: told what changes, watched, and started
// again where a kernel hangs or crashes.
#pragma once

#include "image/layered_image.h"
#include "live/file_watch.h"
#include "live/live_files.h"
#include "live/reloading_compiler.h"
#include "live/worker_process.h"

#include "shaders/shared/limits.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace hyalite::live {

struct SupervisorOptions {
    std::filesystem::path scene;
    std::filesystem::path shaders;
    std::vector<std::string> workerArguments;    // the command, and what device it takes
    std::map<std::string, std::string> settings; // over the scene file's, e.g. render.photons
    double limit = 10;                           // a kernel that takes longer for a piece of its threads is stopped [s]
    std::function<void(const std::string&)> say; // a line for the terminal
};

// What came last of the picture.
struct Picture { // NOLINT(bugprone-exception-escape): no member throws when it is moved
    Json about;
    std::vector<NamedImage> layers; // the first is the picture itself, called "picture"
};

class Supervisor {
public:
    explicit Supervisor(SupervisorOptions options);
    ~Supervisor();
    Supervisor(const Supervisor&) = delete;
    Supervisor& operator=(const Supervisor&) = delete;

    // All there is to know, once its version is another than `seen` or `patience` is over.
    [[nodiscard]] Json state(std::uint64_t seen, std::chrono::milliseconds patience);

    [[nodiscard]] std::shared_ptr<const Picture> picture() const; // nullptr: none yet

    // {"settings": {key: value or null}, "shown": …, "pixel": …, "reset": true}, each as it is wanted.
    // Throws Error(WrongUsage) where it is nothing of the kind.
    void change(const Json& wanted);

    // Both sides of a pixel's path; {"error": …} where that is not to be had in time.
    [[nodiscard]] Json inspect(std::uint32_t x, std::uint32_t y);

    [[nodiscard]] std::vector<std::string> fileNames() const;
    [[nodiscard]] std::optional<std::filesystem::path> findFile(const std::string& name) const;

    // Wakes whoever waits for a state; none waits from now on.
    void close();

private:
    using Clock = std::chrono::steady_clock;

    void run();
    // One worker from its start to its end. Returns false where it should not be started again yet.
    void runWorker();
    void watch(WorkerProcess& worker);
    void hasEnded(const std::string& how, const std::optional<Pulse::Work>& work, bool tookTooLong);
    void handle(Message message);
    void takePicture(Message message);
    // To the worker that runs, if one does: something it has to do with, and to say so.
    void tellChange(Json message);
    [[nodiscard]] Json lookMessage() const;
    [[nodiscard]] std::set<std::string> unproven() const;
    void note(const std::string& line);
    void touch(); // a new version of the state

    SupervisorOptions options_;

    mutable std::mutex mutex_; // of all that follows
    std::condition_variable changed_;
    std::uint64_t version_ = 1;
    bool isClosing_ = false;
    WorkerProcess* worker_ = nullptr; // that runs now
    bool workerIsGone_ = false;
    int failures_ = 0;                        // workers in a row that ended without a picture
    bool isWanted_ = true;                    // start another worker
    std::uint64_t changes_ = 0;               // of files, settings and what is shown, since the start
    std::optional<std::uint64_t> restsAfter_; // changes, all of which the worker has done with

    std::map<std::string, std::string> settings_;
    std::string shown_ = "picture";
    std::uint32_t pixel_ = shared::kNone;
    std::uint32_t revision_ = 1;
    Clock::time_point revisedAt_ = Clock::now();
    std::optional<Clock::time_point> reloadedAt_; // a change of files that no picture has followed yet
    double firstPixelSeconds_ = 0;
    double reloadSeconds_ = 0;
    std::uint32_t seenRevision_ = 0; // of the last picture

    KernelVersions versions_;
    std::map<std::string, std::string> running_; // by kernel: what the worker has compiled
    std::map<std::string, int> strikes_;         // by version: how often it has brought a worker down
    std::map<std::string, Json> stops_;          // by kernel: why it was stopped
    Json errors_ = Json::array();
    Json scene_ = Json::object();
    std::shared_ptr<const Picture> picture_;
    std::deque<std::string> prints_;
    std::uint64_t printCount_ = 0;
    std::deque<std::string> notes_;
    int inspections_ = 0;
    std::optional<Json> path_; // the answer to the last of them

    LiveFiles files_;
    FileWatch shaderWatch_;
    FileWatch sceneWatch_;
    std::thread thread_;
};

} // namespace hyalite::live
