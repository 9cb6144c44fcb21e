// GET  /                       the page           GET  /api/state?seen=N   all but the picture; waits for news
// GET  /api/picture?…          RGBA bytes         GET  /api/picture.png?…, /api/picture.exr   to keep
// POST /api/change {…}         see Supervisor     POST /api/inspect {x, y}
// GET  /api/files              their names        GET  /api/file?name=…    POST /api/file {name, text}
#include "live/live_server.h"

#include "base/error.h"
#include "base/output_file.h"
#include "image/exr.h"
#include "image/png.h"
#include "live/display.h"
#include "live/page.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <httplib.h>
#include <iterator>
#include <thread>

namespace hyalite::live {

namespace {

constexpr std::size_t kLongestBody = std::size_t{4} << 20U; // of a file that is saved
constexpr auto kPatience = std::chrono::seconds(20);
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

// The layer that a request names, and how it is to be shown.
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
            } catch (const std::exception& error) {
                refuse(response, 500, error.what());
            }
        });
        addPage(server);
        addPictures(server);
        addFiles(server);
        server.Get("/api/state", [this](const httplib::Request& request, httplib::Response& response) {
            const std::string seen = request.get_param_value("seen");
            Json state = supervisor_.state(seen.empty() ? 0 : std::strtoull(seen.c_str(), nullptr, 10), kPatience);
            state["may_write"] = mayWrite_;
            answer(response, state);
        });
        server.Post("/api/change", [this](const httplib::Request& request, httplib::Response& response) {
            supervisor_.change(Json::parse(request.body));
            answer(response, Json::object());
        });
        server.Post("/api/inspect", [this](const httplib::Request& request, httplib::Response& response) {
            const Json body = Json::parse(request.body);
            answer(response, supervisor_.inspect(body.at("x").get<std::uint32_t>(), body.at("y").get<std::uint32_t>()));
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
        found.picture = supervisor_.picture();
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
            response.set_header("X-Id", found.picture->about.at("id").dump());
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
            answer(response, {{"files", supervisor_.fileNames()}});
        });
        server.Get("/api/file", [this](const httplib::Request& request, httplib::Response& response) {
            const auto file = supervisor_.findFile(request.get_param_value("name"));
            if (!file) {
                refuse(response, 404, "no such shader, scene or code of the scene");
                return;
            }
            std::ifstream stream(*file, std::ios::binary);
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            answer(response, {{"text", text}});
        });
        server.Post("/api/file", [this](const httplib::Request& request, httplib::Response& response) {
            if (!mayWrite_) {
                refuse(response, 403, "nothing is saved: start hyalite live with --edit");
                return;
            }
            const Json body = Json::parse(request.body);
            const auto file = supervisor_.findFile(body.at("name").get<std::string>());
            if (!file) {
                refuse(response, 404, "no such shader, scene or code of the scene");
                return;
            }
            const auto text = body.at("text").get<std::string>();
            writeFileAtomically(*file, std::as_bytes(std::span(text)));
            answer(response, Json::object());
        });
    }

    Supervisor& supervisor_;
    const Access& access_;
    bool mayWrite_;
};

// Waits for one of the signals that end a server, which all threads leave to it.
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
        throw Error(ExitCode::WrongUsage, "cannot listen at " + options.address + ":" + std::to_string(options.port),
                    "another program may do so: choose another --port, or 0 for any");
    }
    return port;
}

} // namespace

void serve(ServerOptions options) {
    const EndSignals signals; // before there are threads
    httplib::Server server;
    server.new_task_queue = [] { return new httplib::ThreadPool(24); }; // each page holds one in /api/state
    server.set_payload_max_length(kLongestBody);
    server.set_keep_alive_timeout(2); // so long may Ctrl-C take
    const int port = listenAt(server, options);
    const Access access(options.address, port, isLoopback(options.address) ? std::string() : randomToken());
    const auto say = options.supervisor.say;
    Supervisor supervisor(std::move(options.supervisor));
    Handlers handlers(supervisor, access, options.mayWrite);
    handlers.addTo(server);
    say("hyalite live: http://" + options.address + ':' + std::to_string(port) + '/' +
        (access.needsToken() ? "?token=" + access.token() : ""));
    std::thread end([&] {
        signals.wait();
        supervisor.close();
        server.stop();
    });
    const bool served = server.listen_after_bind();
    if (!served) { // not ended by a signal
        ::kill(::getpid(), SIGTERM);
    }
    end.join();
}

bool hasEditor() {
    return kHasCodeMirror;
}

} // namespace hyalite::live
