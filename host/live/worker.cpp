// What the two processes say to one another, by "kind":
//   server: start {scene, good, bad}   look {revision, settings, shown, pixel}   sources   scene
//           pixel {pixel, matters}   inspect {request, x, y}; with all but start and inspect: {change}, a count
//   worker: compiled {kernel, version}   good {versions}   scene {…}   errors {list}   prints {…}
//           picture {…} + floats   path {request, …}   rest {change}: nothing to do after it
#include "live/worker.h"

#include "base/parallel.h"
#include "live/channel.h"
#include "live/error_json.h"
#include "live/live_renderer.h"
#include "live/path_json.h"
#include "live/scene_json.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <unistd.h>

namespace hyalite::live {

namespace {

using Clock = std::chrono::steady_clock;

// Messages as they come, read by a thread of its own: a change must be seen while a pass runs.
class Inbox {
public:
    explicit Inbox(Channel& channel)
        : reader_([this, &channel] {
              while (std::optional<Message> message = channel.receive()) {
                  const std::scoped_lock lock(mutex_);
                  isUnwanted_ = isUnwanted_ || (message->kind() != "inspect" && message->kind() != "pixel");
                  messages_.push_back(*std::move(message));
                  arrived_.notify_one();
              }
              // The server is gone, and whatever kernel runs has nobody to run for
              ::_exit(0);
          }) {}
    ~Inbox() { reader_.detach(); }
    Inbox(const Inbox&) = delete;
    Inbox& operator=(const Inbox&) = delete;

    // Whether something has come that changes the picture.
    [[nodiscard]] bool isUnwanted() const { return isUnwanted_; }

    [[nodiscard]] std::optional<Message> take(bool wait) {
        std::unique_lock lock(mutex_);
        if (wait) {
            arrived_.wait(lock, [&] { return !messages_.empty(); });
        }
        if (messages_.empty()) {
            isUnwanted_ = false;
            return std::nullopt;
        }
        Message message = std::move(messages_.front());
        messages_.pop_front();
        return message;
    }

private:
    std::mutex mutex_;
    std::condition_variable arrived_;
    std::deque<Message> messages_;
    std::atomic<bool> isUnwanted_ = false;
    std::thread reader_;
};

KernelVersions versionsOf(const Json& start) {
    return {start.at("good").get<std::map<std::string, std::string>>(), start.at("bad").get<std::set<std::string>>()};
}

class Worker {
public:
    Worker(const gpu::Context& context, const WorkerOptions& options, Channel& channel, Inbox& inbox, Pulse& pulse,
           const Json& start)
        : channel_(channel), inbox_(inbox), pulse_(pulse), scene_(start.at("scene").get<std::string>()),
          twins_(options.twins),
          compiler_(options.shaders, options.cache, options.shipped, versionsOf(start),
                    [&channel](const std::string& kernel, const std::string& version) {
                        channel.send({{"kind", "compiled"}, {"kernel", kernel}, {"version", version}});
                    }),
          renderer_(context, compiler_, pulse, [&inbox] { return inbox.isUnwanted(); }) {}

    [[noreturn]] void run() {
        while (true) {
            while (std::optional<Message> message = nextMessage()) {
                handle(*message);
            }
            try {
                step();
            } catch (const Interrupted&) {
                renderer_.drop();
                state_ = State::Fresh;
            }
        }
    }

private:
    enum class State { Fresh, Refining, Done, Stuck }; // Stuck: until something changes

    [[nodiscard]] bool hasWork() const { return state_ == State::Fresh || state_ == State::Refining || inspect_; }

    // Waits for one where there is nothing to do, and says up to which change all is done.
    std::optional<Message> nextMessage() {
        if (std::optional<Message> message = inbox_.take(/*wait*/ false)) {
            return message;
        }
        if (hasWork()) {
            return std::nullopt;
        }
        if (restsAfter_ != change_) {
            restsAfter_ = change_;
            channel_.send({{"kind", "rest"}, {"change", change_}});
        }
        return inbox_.take(/*wait*/ true);
    }

    void handle(const Message& message) {
        const std::string kind = message.kind();
        change_ = message.body.value("change", change_);
        if (kind == "look") {
            look(message.body);
        } else if (kind == "sources") {
            sourcesHaveChanged();
        } else if (kind == "scene") {
            loadScene();
        } else if (kind == "pixel") {
            renderer_.lookAtPixel(message.body.value("pixel", shared::kNone));
            if (message.body.value("matters", false) && renderer_.isLoaded()) {
                renderer_.drop();
                state_ = State::Fresh;
            }
        } else if (kind == "inspect") {
            inspect_ = message.body;
        }
    }

    // Only what compiles and is another kernel than the one that runs is a reason to begin the picture anew.
    void sourcesHaveChanged() {
        const std::set<std::string> changed = compiler_.takeChanged();
        const std::vector<std::string> names(changed.begin(), changed.end());
        const auto before = compiler_.running();
        const Activity activity(pulse_, "compiling kernels");
        parallelFor(names.size(), 1, [&](std::size_t i, std::size_t) {
            try {
                static_cast<void>(compiler_.compile(names[i]));
            } catch (const Error&) {
                return; // told with all errors
            }
        });
        std::set<std::string> others;
        const auto after = compiler_.running();
        std::ranges::copy_if(names, std::inserter(others, others.end()), [&](const std::string& kernel) {
            const auto old = before.find(kernel);
            const auto now = after.find(kernel);
            return old == before.end() || now == after.end() || old->second != now->second;
        });
        if (!others.empty() || (state_ == State::Stuck && !names.empty())) {
            renderer_.forget(others);
            runError_.reset();
            state_ = renderer_.isLoaded() ? State::Fresh : State::Stuck;
        }
        tellErrors();
    }

    void look(const Json& body) {
        revision_ = body.value("revision", 0U);
        View view;
        for (const auto& [key, value] : body.at("settings").items()) {
            view.settings.emplace_back(key, value.get<std::string>());
        }
        view.shown = body.value("shown", std::string("picture"));
        view.debugPixel = body.value("pixel", shared::kNone);
        asked_ = view;
        settingError_.reset();
        runError_.reset();
        try {
            renderer_.look(std::move(view));
        } catch (const Error& error) {
            settingError_ = error;
        }
        if (!renderer_.isLoaded()) {
            loadScene();
        } else {
            tellScene();
        }
        state_ = renderer_.isLoaded() ? State::Fresh : State::Stuck;
        tellErrors();
    }

    void loadScene() {
        const Activity activity(pulse_, "loading the scene");
        sceneError_.reset();
        runError_.reset();
        try {
            renderer_.load(scene_, twins_);
            state_ = State::Fresh;
            tellScene();
        } catch (const Error& error) {
            sceneError_ = error;
            state_ = renderer_.isLoaded() ? State::Fresh : State::Stuck;
        }
        tellErrors();
    }

    void step() {
        if (inspect_) {
            const Json request = *inspect_;
            inspect_.reset();
            inspect(request);
            return;
        }
        if (state_ != State::Fresh && state_ != State::Refining) {
            return;
        }
        try {
            if (state_ == State::Fresh) {
                begin();
            }
            if (!renderer_.isDone()) {
                refine();
            }
            if (renderer_.isDone()) {
                state_ = State::Done;
            }
        } catch (const Error& error) {
            renderer_.drop();
            runError_ = error;
            // A kernel that compiles and cannot be run: its arguments are others than the host's, say
            const std::set<std::string> refused = compiler_.noteBad();
            state_ = refused.empty() ? State::Stuck : State::Fresh;
            renderer_.forget(kernelsOf(refused));
            tellErrors();
        }
    }

    // Names in the cache begin with the kernel's.
    static std::set<std::string> kernelsOf(const std::set<std::string>& versions) {
        std::set<std::string> kernels;
        for (const std::string& version : versions) {
            kernels.insert(version.substr(0, version.rfind('-')));
        }
        return kernels;
    }

    void begin() {
        if (renderer_.wantsPreview()) {
            renderer_.begin(/*isPreview*/ true);
            renderer_.renderPass();
            tellPicture();
            passHasEnded();
        }
        renderer_.begin(/*isPreview*/ false);
        state_ = State::Refining;
    }

    void refine() {
        renderer_.renderPass();
        passHasEnded();
        const DebugPrints::Prints prints = renderer_.takePrints();
        if (!prints.lines.empty() || prints.lost > 0) {
            channel_.send({{"kind", "prints"}, {"lines", prints.lines}, {"lost", prints.lost}});
        }
        // So often that the picture is seen to move; reading it back takes its time too
        constexpr auto kBetweenPictures = std::chrono::milliseconds(300);
        if (renderer_.isDone() || firstOfSize_ || Clock::now() - toldAt_ > kBetweenPictures) {
            tellPicture();
            firstOfSize_ = false;
        }
    }

    void passHasEnded() {
        const KernelVersions versions = compiler_.noteGood();
        if (versions.good != toldGood_) {
            toldGood_ = versions.good;
            channel_.send({{"kind", "good"}, {"versions", versions.good}});
        }
        tellErrors();
    }

    void tellPicture() {
        const LiveRenderer::Frame frame = renderer_.frame();
        std::vector<std::byte> bytes;
        const auto add = [&](const Image& image) {
            const auto pixels = std::as_bytes(std::span(image.pixels));
            bytes.insert(bytes.end(), pixels.begin(), pixels.end());
        };
        Json layers = Json::array();
        add(frame.image.picture);
        for (const NamedImage& layer : frame.image.layers) {
            layers.push_back(layer.name);
            add(layer.image);
        }
        if (frame.image.error) {
            layers.push_back("error");
            add(*frame.image.error);
        }
        Json body = describe(frame);
        body["kind"] = "picture";
        body["revision"] = revision_;
        body["layers"] = std::move(layers);
        channel_.send(body, bytes);
        toldAt_ = Clock::now();
        firstOfSize_ = frame.isPreview;
    }

    void tellScene() { channel_.send(describe(renderer_.scene(), renderer_.view(), scene_)); }

    void tellErrors() {
        Json list = Json::array();
        if (sceneError_) {
            list.push_back(describe(*sceneError_, "scene"));
        }
        if (settingError_) {
            list.push_back(describe(*settingError_, "setting"));
        }
        for (const auto& [kernel, error] : compiler_.errors()) {
            Json entry = describe(error, "kernel");
            entry["kernel"] = kernel;
            list.push_back(std::move(entry));
        }
        const bool isCompileError = runError_ && std::ranges::any_of(compiler_.errors(), [&](const auto& entry) {
                                        return entry.second.message() == runError_->message();
                                    });
        if (runError_ && !isCompileError) {
            list.push_back(describe(*runError_, "kernel"));
        }
        Json body{{"kind", "errors"}, {"list", std::move(list)}, {"stand_ins", compiler_.standIns()}};
        if (body != toldErrors_) {
            toldErrors_ = body;
            channel_.send(body);
        }
    }

    void inspect(const Json& request) {
        Json answer{{"kind", "path"}, {"request", request.value("request", 0)}};
        try {
            if (!renderer_.isLoaded()) {
                throw Error(ExitCode::WrongUsage, "there is no scene yet");
            }
            const glm::uvec2 size = renderer_.scene().camera.resolution;
            const auto x = request.value("x", 0U);
            const auto y = request.value("y", 0U);
            if (x >= size.x || y >= size.y) {
                throw Error(ExitCode::WrongUsage, "this pixel is not in the picture");
            }
            answer["path"] = describe(renderer_.inspect(y * size.x + x), renderer_.scene());
            answer["pixel"] = {x, y};
        } catch (const Error& error) {
            answer["error"] = error.what();
        }
        channel_.send(answer);
    }

    Channel& channel_;
    Inbox& inbox_;
    Pulse& pulse_;
    std::filesystem::path scene_;
    reference::TwinSources twins_;
    ReloadingCompiler compiler_;
    LiveRenderer renderer_;
    State state_ = State::Stuck;
    std::uint32_t revision_ = 0;
    std::uint64_t change_ = 0; // the last one that a message told of
    std::optional<std::uint64_t> restsAfter_;
    View asked_;
    std::optional<Json> inspect_;
    std::optional<Error> sceneError_;
    std::optional<Error> settingError_;
    std::optional<Error> runError_;
    std::map<std::string, std::string> toldGood_;
    Json toldErrors_;
    Clock::time_point toldAt_;
    bool firstOfSize_ = true; // the next picture is the first of its size
};

} // namespace

void runWorker(const gpu::Context& context, const WorkerOptions& options) {
    Channel channel(options.channel);
    Pulse pulse(options.pulse);
    Inbox inbox(channel);
    const std::optional<Message> start = inbox.take(/*wait*/ true);
    Worker(context, options, channel, inbox, pulse, start->body).run();
}

} // namespace hyalite::live
