// Keeps a worker running, and passes on what happens: what the page wants and which files were saved to the worker,
// what the worker sends to the page's state. Starts another worker when one hangs or crashes.
#pragma once

#include "live/page/page_state.h"
#include "live/supervisor/event_queue.h"
#include "live/supervisor/file_watch.h"
#include "live/supervisor/worker_life.h"
#include "live/supervisor/worker_process.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace hyalite::live {

struct SupervisorOptions {
    std::filesystem::path scene;
    std::filesystem::path shaders;
    std::string program = "/proc/self/exe";      // of the worker
    std::vector<std::string> workerArguments;    // its command and its device options
    std::map<std::string, std::string> settings; // over the scene file's, e.g. render.photons
    double limit = 10;                           // see WorkerLife [s]
    std::function<void(const std::string&)> say; // prints a line to the terminal
};

class Supervisor {
public:
    explicit Supervisor(SupervisorOptions options);
    ~Supervisor(); // stops the worker
    Supervisor(const Supervisor&) = delete;
    Supervisor& operator=(const Supervisor&) = delete;

    [[nodiscard]] PageState& page() { return page_; }

    // From any thread.
    void change(const ChangeRequest& request);
    [[nodiscard]] InspectedPath inspect(const PixelRequest& pixel); // waits for the worker
    // Ends the worker, and wakes all who wait for the page's state.
    void close();

private:
    using Clock = std::chrono::steady_clock;

    // ---- in the supervisor's thread ----

    void run();
    void waitForAChange();
    void runWorker();
    // Until the worker has ended or the server does; nothing in the latter case.
    [[nodiscard]] std::optional<WorkerLife::End> attend(WorkerProcess& worker);
    void endWorker(const WorkerLife::End& end);
    void note(const std::string& line);
    void pollFiles(WorkerProcess& worker);
    void sendLook(WorkerProcess& worker);

    // An event while that worker runs.
    void handle(WorkerProcess& worker, const LookChanged& event);
    void handle(WorkerProcess& worker, const PixelChanged& event);
    void handle(WorkerProcess& worker, const InspectPixel& event);
    void handle(WorkerProcess& worker, WorkerMessage message);
    void handle(WorkerProcess& worker, const WorkerGone& event);
    void handle(WorkerProcess& worker, const Closing& event);
    void receive(const KernelCompiled& message);
    void receive(KernelsProved message);
    void receive(Errors message);
    void receive(SceneInfo message);
    void receive(const FilesRead& message);
    void receive(const Prints& message);
    void receive(PictureRendered message);
    void receive(InspectedPath message);
    void receive(const WorkDone& message);

    SupervisorOptions options_;
    PageState page_;
    EventQueue events_;

    // Of the supervisor's thread alone:
    WorkerLife life_;
    FileWatch shaderWatch_;
    FileWatch sceneWatch_;
    Clock::time_point polledAt_ = Clock::now();
    std::optional<WorkerGone> gone_; // the worker that runs has closed its channel
    bool isClosing_ = false;
    std::uint32_t sentRevision_ = 0; // of the look that the worker was sent last

    std::thread thread_;
};

} // namespace hyalite::live
