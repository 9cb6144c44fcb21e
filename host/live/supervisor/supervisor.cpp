#include "live/supervisor/supervisor.h"

#include "base/error.h"

#include <utility>

namespace hyalite::live {

namespace {

using namespace std::chrono_literals;

constexpr auto kBetweenLooks = 50ms;  // at the worker's pulse
constexpr auto kBetweenPolls = 100ms; // of files
constexpr auto kInspectionPatience = 60s;

// Puts a worker's messages into the queue, from a thread of its own that ends with the channel.
class MessageReader {
public:
    MessageReader(Channel& channel, EventQueue& events)
        : channel_(channel), thread_([&channel, &events] {
              std::string complaint;
              try {
                  while (std::optional<Packet> packet = channel.receive()) {
                      events.push(readWorkerMessage(*std::move(packet)));
                  }
              } catch (const std::exception& error) {
                  // A kernel that writes out of bounds may destroy what its worker sends
                  complaint = error.what();
              }
              events.push(WorkerGone{complaint});
          }) {}
    ~MessageReader() { join(); }
    MessageReader(const MessageReader&) = delete;
    MessageReader& operator=(const MessageReader&) = delete;

    void join() {
        if (thread_.joinable()) {
            channel_.close();
            thread_.join();
        }
    }

private:
    Channel& channel_;
    std::thread thread_;
};

std::map<std::string, FileStamp> stampedScene(const std::filesystem::path& scene) {
    return {{scene.string(), stampOf(scene).value_or(FileStamp())}};
}

} // namespace

Supervisor::Supervisor(SupervisorOptions options)
    : options_(std::move(options)),
      page_(options_.scene.filename().string(), options_.settings, LiveFiles(options_.shaders, options_.scene)),
      life_(options_.limit, options_.shaders), shaderWatch_(options_.shaders),
      sceneWatch_(stampedScene(options_.scene)), thread_([this] { run(); }) {}

Supervisor::~Supervisor() {
    close();
    thread_.join();
}

void Supervisor::close() {
    page_.close();
    events_.push(Closing());
}

void Supervisor::change(const ChangeRequest& request) {
    if (request.isPixelAlone()) {
        const bool restarts = page_.files()->anyShaderHas("debugPixel(");
        page_.choosePixel(*request.pixel);
        events_.push(PixelChanged{restarts});
    } else {
        page_.change(request);
        events_.push(LookChanged());
    }
}

InspectedPath Supervisor::inspect(const PixelRequest& pixel) {
    const std::uint64_t request = page_.beginInspection();
    events_.push(InspectPixel{.request = request, .x = pixel.x, .y = pixel.y});
    return page_.awaitInspection(request, kInspectionPatience);
}

void Supervisor::note(const std::string& line) {
    page_.addNote(line);
    options_.say(line);
}

void Supervisor::run() {
    while (!isClosing_) {
        try {
            if (life_.wantsWorker()) {
                runWorker();
            } else {
                waitForAChange();
            }
        } catch (const std::exception& error) { // no process, no thread, no memory
            life_.startFails();
            note(error.what());
        }
        page_.setWorkerWanted(life_.wantsWorker());
    }
}

void Supervisor::waitForAChange() {
    const std::optional<Event> event = events_.take(kBetweenPolls);
    const bool shaders = shaderWatch_.hasChanged();
    const bool scene = sceneWatch_.hasChanged();
    if (shaders || scene) {
        page_.filesChanged();
    }
    if (shaders || scene || (event && std::holds_alternative<LookChanged>(*event))) {
        life_.somethingChanges();
        page_.setWorkerWanted(true);
    }
    if (event && std::holds_alternative<InspectPixel>(*event)) {
        page_.failInspection("no worker is running");
    }
    isClosing_ = event && std::holds_alternative<Closing>(*event);
}

void Supervisor::runWorker() {
    WorkerProcess worker(options_.workerArguments, options_.program);
    life_.workerStarts();
    page_.workerStarts();
    gone_.reset();
    events_.dropWorkerEvents(); // of the worker before
    sentRevision_ = 0;
    send(worker.channel(), Start{.scene = options_.scene.string(), .versions = life_.versions()});
    sendLook(worker);
    MessageReader reader(worker.channel(), events_);
    std::optional<WorkerLife::End> end = attend(worker);
    if (!end) {
        return;
    }
    // What the worker has sent before its end says which kernels it ran
    reader.join();
    while (!gone_) {
        if (std::optional<Event> event = events_.take(kBetweenLooks)) {
            std::visit([&](auto& any) { handle(worker, std::move(any)); }, *event);
        }
    }
    endWorker(*end);
}

std::optional<WorkerLife::End> Supervisor::attend(WorkerProcess& worker) {
    while (!isClosing_ && !gone_) {
        if (std::optional<Event> event = events_.take(kBetweenLooks)) {
            std::visit([&](auto& any) { handle(worker, std::move(any)); }, *event);
        }
        if (const auto work = worker.pulse().look(); life_.isOverdue(work)) {
            worker.kill();
            return WorkerLife::End{.how = worker.wait(), .work = work, .isOverdue = true};
        }
        pollFiles(worker);
    }
    if (isClosing_) {
        return std::nullopt;
    }
    const auto work = worker.pulse().look();
    if (!gone_->complaint.empty()) {
        worker.kill();
        static_cast<void>(worker.wait());
        return WorkerLife::End{.how = "was stopped: it sent a " + gone_->complaint, .work = work};
    }
    return WorkerLife::End{.how = worker.wait(), .work = work};
}

void Supervisor::endWorker(const WorkerLife::End& end) {
    const std::string line = life_.workerEnds(end);
    page_.showStops(life_.stops());
    page_.failInspection("the worker ended before it could answer");
    note(line);
}

void Supervisor::pollFiles(WorkerProcess& worker) {
    if (Clock::now() - polledAt_ < kBetweenPolls) {
        return;
    }
    polledAt_ = Clock::now();
    if (shaderWatch_.hasChanged()) {
        send(worker.channel(), ShadersChanged{page_.filesChanged()});
    }
    if (sceneWatch_.hasChanged()) {
        send(worker.channel(), SceneChanged{page_.filesChanged()});
    }
}

void Supervisor::sendLook(WorkerProcess& worker) {
    const Look look = page_.look();
    if (look.revision != sentRevision_) { // one message for several changes that come while another is sent
        sentRevision_ = look.revision;
        send(worker.channel(), look);
    }
}

void Supervisor::handle(WorkerProcess& worker, const LookChanged& /*event*/) {
    life_.somethingChanges();
    sendLook(worker);
}

void Supervisor::handle(WorkerProcess& worker, const PixelChanged& event) {
    const Look look = page_.look();
    send(worker.channel(), PixelChosen{.pixel = look.pixel, .restarts = event.restarts, .change = look.change});
}

void Supervisor::handle(WorkerProcess& worker, const InspectPixel& event) {
    send(worker.channel(), event);
}

void Supervisor::handle(WorkerProcess& /*worker*/, WorkerMessage message) {
    std::visit([&](auto& any) { receive(std::move(any)); }, message);
}

void Supervisor::handle(WorkerProcess& /*worker*/, const WorkerGone& event) {
    gone_ = event;
}

void Supervisor::handle(WorkerProcess& /*worker*/, const Closing& /*event*/) {
    isClosing_ = true;
}

void Supervisor::receive(const KernelCompiled& message) {
    life_.kernelCompiled(message);
}

void Supervisor::receive(KernelsProved message) {
    life_.kernelsProved(std::move(message));
}

void Supervisor::receive(Errors message) {
    life_.standInsAre(message.standIns);
    page_.showErrors(std::move(message.list));
    page_.showStops(life_.stops());
}

void Supervisor::receive(SceneInfo message) {
    page_.show(std::move(message));
}

void Supervisor::receive(const FilesRead& message) {
    std::map<std::string, FileStamp> files = message.files;
    files.merge(stampedScene(options_.scene));
    sceneWatch_.watch(files);
}

void Supervisor::receive(const Prints& message) {
    std::vector<std::string> lines = message.lines;
    if (message.lost > 0) {
        lines.push_back("… and " + std::to_string(message.lost) + " more");
    }
    for (const std::string& line : lines) {
        options_.say(line);
    }
    page_.addPrints(lines);
}

void Supervisor::receive(PictureRendered message) {
    if (page_.show(std::move(message))) {
        life_.pictureArrives();
    }
}

void Supervisor::receive(InspectedPath message) {
    page_.answer(std::move(message));
}

void Supervisor::receive(const WorkDone& message) {
    page_.finished(message);
}

} // namespace hyalite::live
