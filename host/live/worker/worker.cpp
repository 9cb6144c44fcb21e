#include "live/worker/worker.h"

#include "base/parallel.h"
#include "live/worker/inbox.h"
#include "live/worker/live_renderer.h"
#include "live/worker/path_json.h"
#include "live/worker/scene_files.h"
#include "live/worker/worker_reports.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace hyalite::live {

namespace {

// Names in the cache begin with the kernel's.
std::set<std::string> kernelsOf(const std::set<std::string>& versions) {
    std::set<std::string> kernels;
    for (const std::string& version : versions) {
        kernels.insert(version.substr(0, version.rfind('-')));
    }
    return kernels;
}

class Worker {
public:
    Worker(const gpu::Context& context, const WorkerOptions& options, Channel& channel, Inbox& inbox, Pulse& pulse,
           const Start& start)
        : inbox_(inbox), pulse_(pulse), scene_(start.scene), twins_(options.twins),
          compiler_(options.shaders, options.cache, options.shipped, start.versions,
                    [&channel](const std::string& kernel, const std::string& version) {
                        send(channel, KernelCompiled{.kernel = kernel, .version = version});
                    }),
          reports_(channel, compiler_), renderer_(context, compiler_, pulse, [&inbox] { return inbox.isUnwanted(); }) {}

    [[noreturn]] void run() {
        while (true) {
            while (const std::optional<ServerMessage> message = nextMessage()) {
                std::visit([&](const auto& any) { handle(any); }, *message);
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
    enum class State {
        Fresh,    // the picture has to start
        Refining, // passes are left to do
        Done,
        Stuck, // nothing can be rendered until something changes
    };

    [[nodiscard]] bool hasWork() const { return state_ == State::Fresh || state_ == State::Refining || inspection_; }

    // Waits for a message when there is nothing to do.
    std::optional<ServerMessage> nextMessage() {
        if (std::optional<ServerMessage> message = inbox_.take(/*wait*/ false)) {
            return message;
        }
        if (hasWork()) {
            return std::nullopt;
        }
        reports_.done(change_);
        return inbox_.take(/*wait*/ true);
    }

    // Changes may overtake one another on their way here.
    void noteChange(std::uint64_t change) { change_ = std::max(change_, change); }

    void restart() { state_ = renderer_.isLoaded() ? State::Fresh : State::Stuck; }

    // ---- messages ----

    void handle(const Start& /*message*/) {} // only the first message is one

    void handle(const Look& message) {
        noteChange(message.change);
        revision_ = message.revision;
        View view;
        view.settings.assign(message.settings.begin(), message.settings.end());
        view.shown = message.shown;
        view.debugPixel = message.pixel;
        errors_.setting.reset();
        errors_.run.reset();
        auto files = filesRead_;
        files.merge(stampsOfNamedFiles(message.settings, scene_.parent_path()));
        try {
            renderer_.look(std::move(view));
        } catch (const Error& error) {
            errors_.setting = error;
        }
        if (renderer_.isLoaded()) {
            reports_.files(std::move(files));
            reports_.scene(renderer_);
            restart();
            reports_.errors(errors_);
        } else {
            load();
        }
    }

    // The picture restarts only when a kernel that it runs compiles to something else.
    void handle(const ShadersChanged& message) {
        noteChange(message.change);
        const std::set<std::string> changed = compiler_.takeChanged();
        const std::vector<std::string> names(changed.begin(), changed.end());
        const auto before = compiler_.running();
        const Activity activity(pulse_, "compiling kernels");
        parallelFor(names.size(), 1, [&](std::size_t i, std::size_t) {
            try {
                static_cast<void>(compiler_.compile(names[i]));
            } catch (const Error&) {
                return; // reported with all errors
            }
        });
        std::set<std::string> replaced;
        const auto after = compiler_.running();
        std::ranges::copy_if(names, std::inserter(replaced, replaced.end()), [&](const std::string& kernel) {
            const auto old = before.find(kernel);
            const auto now = after.find(kernel);
            return old == before.end() || now == after.end() || old->second != now->second;
        });
        if (!replaced.empty() || (state_ == State::Stuck && !names.empty())) {
            renderer_.forget(replaced);
            errors_.run.reset();
            restart();
        }
        reports_.errors(errors_);
    }

    void handle(const SceneChanged& message) {
        noteChange(message.change);
        load();
    }

    void handle(const PixelChosen& message) {
        noteChange(message.change);
        renderer_.lookAtPixel(message.pixel);
        if (message.restarts && renderer_.isLoaded()) {
            renderer_.drop();
            state_ = State::Fresh;
        }
    }

    void handle(const InspectPixel& message) { inspection_ = message; }

    void load() {
        const Activity activity(pulse_, "loading the scene");
        errors_.scene.reset();
        errors_.run.reset();
        // Stamped before they are read: what is saved from now on will be read again
        filesRead_ = stampsOfScene(scene_);
        auto files = filesRead_;
        const auto& settings = renderer_.view().settings;
        files.merge(stampsOfNamedFiles({settings.begin(), settings.end()}, scene_.parent_path()));
        try {
            renderer_.load(scene_, twins_);
            reports_.scene(renderer_);
        } catch (const Error& error) {
            errors_.scene = error;
        }
        restart();
        reports_.files(std::move(files));
        reports_.errors(errors_);
    }

    // ---- work ----

    void step() {
        if (inspection_) {
            const InspectPixel request = *inspection_;
            inspection_.reset();
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
                renderPass();
            }
            if (renderer_.isDone()) {
                state_ = State::Done;
            }
        } catch (const Error& error) {
            renderer_.drop();
            errors_.run = error;
            // A kernel may compile and still not run: its arguments differ from the host's, for example
            const std::set<std::string> refused = compiler_.noteBad();
            state_ = refused.empty() ? State::Stuck : State::Fresh;
            renderer_.forget(kernelsOf(refused));
            reports_.errors(errors_);
        }
    }

    // Renders the preview, if the picture is large enough to have one, and prepares the picture.
    void begin() {
        if (renderer_.wantsPreview()) {
            renderer_.begin(/*isPreview*/ true);
            renderer_.renderPass();
            reports_.pictureOfPass(renderer_, revision_);
            passEnds();
        }
        renderer_.begin(/*isPreview*/ false);
        state_ = State::Refining;
    }

    void renderPass() {
        renderer_.renderPass();
        passEnds();
        reports_.prints(renderer_.takePrints());
        reports_.pictureOfPass(renderer_, revision_);
    }

    void passEnds() {
        reports_.proved(compiler_.noteGood());
        reports_.errors(errors_);
    }

    void inspect(const InspectPixel& request) {
        InspectedPath answer{.request = request.request, .error = {}, .path = {}};
        try {
            if (!renderer_.isLoaded()) {
                throw Error(ExitCode::WrongUsage, "no scene is loaded yet");
            }
            const glm::uvec2 size = renderer_.scene().camera.resolution;
            if (request.x >= size.x || request.y >= size.y) {
                throw Error(ExitCode::WrongUsage, "the pixel is outside the picture");
            }
            answer.path = describe(renderer_.inspect(request.y * size.x + request.x), renderer_.scene());
        } catch (const Error& error) {
            answer.error = error.what();
        }
        reports_.path(std::move(answer));
    }

    Inbox& inbox_;
    Pulse& pulse_;
    std::filesystem::path scene_;
    reference::TwinSources twins_;
    ReloadingCompiler compiler_;
    WorkerReports reports_;
    LiveRenderer renderer_;
    State state_ = State::Stuck;
    std::uint32_t revision_ = 0;
    std::uint64_t change_ = 0; // the last one that a message was about; 0: none yet
    std::optional<InspectPixel> inspection_;
    StandingErrors errors_;
    std::map<std::string, FileStamp> filesRead_; // that the scene was loaded from, before it was
};

} // namespace

void runWorker(const gpu::Context& context, const WorkerOptions& options) {
    Channel channel(options.channel);
    Pulse pulse(options.pulse);
    Inbox inbox(channel);
    const std::optional<ServerMessage> first = inbox.take(/*wait*/ true);
    const Start* start = std::get_if<Start>(&*first);
    if (start == nullptr) {
        throw Error(ExitCode::BadInput, "the first message of the server is not 'start'");
    }
    Worker(context, options, channel, inbox, pulse, *start).run();
}

} // namespace hyalite::live
