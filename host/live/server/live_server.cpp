// GET  /                page                    GET  /api/state?seen=N    StateAnswer; waits for news
// GET  /api/picture?…   RGBA bytes              GET  /api/picture.png?…, /api/picture.exr   files to save
// POST /api/change      ChangeRequest           POST /api/inspect         PixelRequest
// GET  /api/files       names of files          GET  /api/file?name=…     POST /api/file   FileRequest
#include "live/server/live_server.h"

#include "base/error.h"
#include "base/output_file.h"
#include "image/exr.h"
#include "image/png.h"
#include "live/server/display.h"
#include "live/server/page.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <fstream>
#include <httplib.h>
#include <iterator>
#include <thread>

namespace hyalite::live {

namespace {

constexpr std::size_t kLongestBody = std::size_t{4} << 20U; // of a saved file [bytes]
constexpr auto kPatience = std::chrono::seconds(20);        // of a request for the state
constexpr std::size_t kThreads = 24;
static_assert(kThreads >= 2 * PageState::kMostWaiting, "requests that wait must leave threads to the others");
constexpr const char* kJson = "application/json";

std::string cookieToken(const std::string& cookies) {
    const std::string name = "hyalite_token=";
    const std::size_t found = cookies.find(name);
    if (found == std::string::npos) {
        return {};
    }
    const std::size_t first = found + name.size();
    return cookies.substr(first, cookies.find(';', first) - first);
}

void refuse(httplib::Response& response, int status, const std::string& why) {
    response.status = status;
    response.set_content(Json{{"error", why}}.dump(), kJson);
}

void answer(httplib::Response& response, const Json& body) {
    response.set_content(body.dump(-1, ' ', false, Json::error_handler_t::replace), kJson);
}

// The layer that a request names, and how to display it.
struct Wanted {
    std::shared_ptr<const Picture> picture;
    const NamedImage* layer = nullptr;
    Display display;
};

class Handlers {
public:
    Handlers(Supervisor& supervisor, const Access& access, bool mayWrite)
        : supervisor_(supervisor), access_(access), mayWrite_(mayWrite) {}

    void addTo(httplib::Server& server) {
        server.set_pre_routing_handler(
            [this](const httplib::Request& request, httplib::Response& response) { return admit(request, response); });
        server.set_exception_handler([](const httplib::Request&, httplib::Response& response, const auto& failure) {
            try {
                std::rethrow_exception(failure);
            } catch (const Error& error) {
                refuse(response, error.code() == ExitCode::OutputNotWritten ? 500 : 400, error.what());
            } catch (const Json::exception& error) {
                refuse(response, 400, error.what());
            } catch (const std::exception& error) {
                refuse(response, 500, error.what());
            }
        });
        addPage(server);
        addPictures(server);
        addFiles(server);
        server.Get("/api/state", [this](const httplib::Request& request, httplib::Response& response) {
            const std::string seen = request.get_param_value("seen");
            StateAnswer state = supervisor_.page().state(std::strtoull(seen.c_str(), nullptr, 10), kPatience);
            state.mayWrite = mayWrite_;
            answer(response, state);
        });
        server.Post("/api/change", [this](const httplib::Request& request, httplib::Response& response) {
            supervisor_.change(readChangeRequest(Json::parse(request.body)));
            answer(response, Json::object());
        });
        server.Post("/api/inspect", [this](const httplib::Request& request, httplib::Response& response) {
            answer(response, supervisor_.inspect(Json::parse(request.body).get<PixelRequest>()));
        });
    }

private:
    httplib::Server::HandlerResponse admit(const httplib::Request& request, httplib::Response& response) const {
        response.set_header("X-Content-Type-Options", "nosniff");
        response.set_header("Referrer-Policy", "no-referrer");
        response.set_header("Cache-Control", "no-store");
        response.set_header("Cross-Origin-Resource-Policy", "same-origin");
        response.set_header(
            "Content-Security-Policy",
            "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; connect-src "
            "'self'; img-src 'self' data:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'");
        const std::string given = request.get_param_value("token");
        const auto refusal =
            access_.refusal({.host = request.get_header_value("Host"),
                             .origin = request.get_header_value("Origin"),
                             .fetchSite = request.get_header_value("Sec-Fetch-Site"),
                             .token = given.empty() ? cookieToken(request.get_header_value("Cookie")) : given,
                             .writes = request.method != "GET" && request.method != "HEAD",
                             .contentType = request.get_header_value("Content-Type")});
        if (refusal) {
            refuse(response, 403, *refusal);
            return httplib::Server::HandlerResponse::Handled;
        }
        if (!given.empty() && access_.needsToken()) {
            response.set_header("Set-Cookie",
                                "hyalite_token=" + access_.token() + "; HttpOnly; SameSite=Strict; Path=/");
        }
        return httplib::Server::HandlerResponse::Unhandled;
    }

    static void addPage(httplib::Server& server) {
        for (const Asset& asset : pageAssets()) {
            server.Get(std::string(asset.path), [&asset](const httplib::Request&, httplib::Response& response) {
                response.set_content(asset.text.data(), asset.text.size(), std::string(asset.type));
            });
        }
    }

    [[nodiscard]] Wanted wanted(const httplib::Request& request) const {
        Wanted found;
        found.picture = supervisor_.page().picture();
        if (!found.picture) {
            throw Error(ExitCode::WrongUsage, "there is no picture yet");
        }
        const auto& layers = found.picture->layers;
        const std::string name = request.has_param("layer") ? request.get_param_value("layer") : "picture";
        const auto layer = std::ranges::find(layers, name, &NamedImage::name);
        found.layer = layer == layers.end() ? &layers.front() : &*layer;
        found.display.exposure =
            std::clamp(std::strtod(request.get_param_value("exposure").c_str(), nullptr), -30.0, 30.0);
        found.display.toneMap = request.get_param_value("tone_map");
        found.display.isQuantity = found.layer->name == "error" || request.get_param_value("quantity") == "1";
        return found;
    }

    void addPictures(httplib::Server& server) {
        server.Get("/api/picture", [this](const httplib::Request& request, httplib::Response& response) {
            const Wanted found = wanted(request);
            const std::vector<std::uint8_t> bytes = shownBytes(found.layer->image, found.display);
            response.set_header("X-Width", std::to_string(found.layer->image.width));
            response.set_header("X-Id", std::to_string(found.picture->info.id));
            response.set_content(reinterpret_cast<const char*>(bytes.data()), bytes.size(), "application/octet-stream");
        });
        server.Get("/api/picture.png", [this](const httplib::Request& request, httplib::Response& response) {
            const Wanted found = wanted(request);
            const std::vector<std::byte> png = encodePng(shownImage(found.layer->image, found.display));
            response.set_header("Content-Disposition", "attachment; filename=hyalite.png");
            response.set_content(reinterpret_cast<const char*>(png.data()), png.size(), "image/png");
        });
        server.Get("/api/picture.exr", [this](const httplib::Request& request, httplib::Response& response) {
            const Wanted found = wanted(request);
            std::vector<Layer> layers;
            for (const NamedImage& layer : found.picture->layers) {
                layers.push_back({layer.name == "picture" ? "" : layer.name, layer.image});
            }
            const std::vector<std::byte> exr = encodeExr(layers, {{"software", "hyalite"}});
            response.set_header("Content-Disposition", "attachment; filename=hyalite.exr");
            response.set_content(reinterpret_cast<const char*>(exr.data()), exr.size(), "image/x-exr");
        });
    }

    void addFiles(httplib::Server& server) {
        server.Get("/api/files", [this](const httplib::Request&, httplib::Response& response) {
            answer(response, {{"files", supervisor_.page().files()->names()}});
        });
        server.Get("/api/file", [this](const httplib::Request& request, httplib::Response& response) {
            const auto file = supervisor_.page().files()->find(request.get_param_value("name"));
            if (!file) {
                refuse(response, 404, "not a file of the shaders folder or of the scene");
                return;
            }
            std::ifstream stream(*file, std::ios::binary);
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            answer(response, {{"text", text}});
        });
        server.Post("/api/file", [this](const httplib::Request& request, httplib::Response& response) {
            if (!mayWrite_) {
                refuse(response, 403, "the page may not save files: start hyalite live with --edit");
                return;
            }
            const auto saved = Json::parse(request.body).get<FileRequest>();
            const auto file = supervisor_.page().files()->find(saved.name);
            if (!file) {
                refuse(response, 404, "not a file of the shaders folder or of the scene");
                return;
            }
            writeFileAtomically(*file, std::as_bytes(std::span(saved.text)));
            answer(response, Json::object());
        });
    }

    Supervisor& supervisor_;
    const Access& access_;
    bool mayWrite_;
};

// Waits for SIGINT or SIGTERM. All threads block them, so that only wait() receives them.
class EndSignals {
public:
    EndSignals() {
        ::sigemptyset(&set_);
        ::sigaddset(&set_, SIGINT);
        ::sigaddset(&set_, SIGTERM);
        ::pthread_sigmask(SIG_BLOCK, &set_, nullptr);
    }
    void wait() const {
        int signal = 0;
        ::sigwait(&set_, &signal);
    }

private:
    sigset_t set_{};
};

int listenAt(httplib::Server& server, const ServerOptions& options) {
    if (options.port != 0 && server.bind_to_port(options.address, options.port)) {
        return options.port;
    }
    const int port = options.port == 0 || options.portIsAChoice ? server.bind_to_any_port(options.address) : -1;
    if (port <= 0) {
        throw Error(ExitCode::WrongUsage, "cannot listen at " + hostAndPort(options.address, options.port),
                    "the port may be taken: choose another --port, or 0 for any free one");
    }
    return port;
}

} // namespace

void serve(ServerOptions options) {
    const EndSignals signals; // before there are threads
    httplib::Server server;
    server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server.set_payload_max_length(kLongestBody);
    server.set_keep_alive_timeout(2); // [s]; Ctrl-C waits for it
    options.address = withoutBrackets(options.address);
    const int port = listenAt(server, options);
    const Access access(options.address, port, isLoopback(options.address) ? std::string() : randomToken());
    const auto say = options.supervisor.say;
    Supervisor supervisor(std::move(options.supervisor));
    Handlers handlers(supervisor, access, options.mayWrite);
    handlers.addTo(server);
    say("hyalite live: http://" + hostAndPort(options.address, port) + '/' +
        (access.needsToken() ? "?token=" + access.token() : ""));
    std::atomic<bool> hasEnded = false;
    std::thread end([&] {
        signals.wait();
        supervisor.close();
        while (!server.is_running() && !hasEnded) { // until then, stop() does nothing
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        server.stop();
    });
    const bool served = server.listen_after_bind();
    hasEnded = true;
    if (!served) { // it ended without a signal
        ::kill(::getpid(), SIGTERM);
    }
    end.join();
}

bool hasEditor() {
    return kHasCodeMirror;
}

} // namespace hyalite::live
