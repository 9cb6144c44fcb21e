// Every message between the live server and its worker, one struct each. On the wire a message is a JSON object whose
// "kind" is the struct's kKind; a picture's pixels follow it as bytes.
#pragma once

#include "live/messages/channel.h"
#include "live/messages/error_report.h"
#include "live/messages/file_stamp.h"

#include "shaders/shared/limits.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace hyalite::live {

// Versions of kernels, by their names in the cache.
struct KernelVersions {
    std::map<std::string, std::string> good; // by kernel: the last version with which a pass finished
    std::set<std::string> bad;               // versions that hung or crashed

    static void fields(auto& self, auto&& field) {
        field("good", self.good);
        field("bad", self.bad);
    }
};

// ---- from the server to the worker -------------------------------------------------------------------------------

// The first message.
struct Start {
    static constexpr const char* kKind = "start";
    std::string scene; // path of the scene file
    KernelVersions versions;

    static void fields(auto& self, auto&& field) {
        field("scene", self.scene);
        field("versions", self.versions);
    }
};

// What the page wants to see. `change` counts all changes since the server started; the worker returns it in WorkDone.
struct Look {
    static constexpr const char* kKind = "look";
    std::uint32_t revision = 0;                  // of settings, view and pixel; returned with every picture
    std::map<std::string, std::string> settings; // keys of the scene file and values, e.g. render.photons
    std::string shown = "picture";               // see View::shown
    std::uint32_t pixel = shared::kNone;         // that debugPixel() is true for: y * width + x
    std::uint64_t change = 0;

    static void fields(auto& self, auto&& field) {
        field("revision", self.revision);
        field("settings", self.settings);
        field("shown", self.shown);
        field("pixel", self.pixel);
        field("change", self.change);
    }
};

// A file of the shaders folder was saved.
struct ShadersChanged {
    static constexpr const char* kKind = "shaders_changed";
    std::uint64_t change = 0;
    static void fields(auto& self, auto&& field) { field("change", self.change); }
};

// The scene file, or a file that it names, was saved.
struct SceneChanged {
    static constexpr const char* kKind = "scene_changed";
    std::uint64_t change = 0;
    static void fields(auto& self, auto&& field) { field("change", self.change); }
};

// Another pixel was clicked.
struct PixelChosen {
    static constexpr const char* kKind = "pixel_chosen";
    std::uint32_t pixel = shared::kNone;
    bool restarts = false; // some shader asks for the pixel, so that the picture has to start again
    std::uint64_t change = 0;

    static void fields(auto& self, auto&& field) {
        field("pixel", self.pixel);
        field("restarts", self.restarts);
        field("change", self.change);
    }
};

// The worker answers with InspectedPath.
struct InspectPixel {
    static constexpr const char* kKind = "inspect_pixel";
    std::uint64_t request = 0; // number of the request
    std::uint32_t x = 0;
    std::uint32_t y = 0;

    static void fields(auto& self, auto&& field) {
        field("request", self.request);
        field("x", self.x);
        field("y", self.y);
    }
};

using ServerMessage = std::variant<Start, Look, ShadersChanged, SceneChanged, PixelChosen, InspectPixel>;

// ---- from the worker to the server -------------------------------------------------------------------------------

// This version of the kernel runs from now on.
struct KernelCompiled {
    static constexpr const char* kKind = "kernel_compiled";
    std::string kernel;
    std::string version;

    static void fields(auto& self, auto&& field) {
        field("kernel", self.kernel);
        field("version", self.version);
    }
};

// A pass has finished with these versions, by kernel.
struct KernelsProved {
    static constexpr const char* kKind = "kernels_proved";
    std::map<std::string, std::string> good;
    static void fields(auto& self, auto&& field) { field("good", self.good); }
};

// All errors that stand; they replace those sent before.
struct Errors {
    static constexpr const char* kKind = "errors";
    std::vector<ErrorReport> list;
    std::set<std::string> standIns; // kernels that run an older version than their source

    static void fields(auto& self, auto&& field) {
        field("list", self.list);
        field("stand_ins", self.standIns);
    }
};

struct CameraInfo {
    std::array<double, 3> position{}; // [m]
    std::array<double, 3> lookAt{};   // [m]
    std::array<double, 3> up{};
    double fov = 0; // of the picture's height [degrees]
    std::array<std::uint32_t, 2> resolution{};

    static void fields(auto& self, auto&& field) {
        field("position", self.position);
        field("look_at", self.lookAt);
        field("up", self.up);
        field("fov", self.fov);
        field("resolution", self.resolution);
    }
};

// The scene as it renders, with the page's settings.
struct SceneInfo {
    static constexpr const char* kKind = "scene";
    CameraInfo camera;
    Json settings = Json::object(); // values by key, e.g. render.photons
    std::string shown;
    std::vector<std::string> code; // paths of the GLSL files that it uses

    static void fields(auto& self, auto&& field) {
        field("camera", self.camera);
        field("settings", self.settings);
        field("shown", self.shown);
        field("code", self.code);
    }
};

// The files that the scene is read from, with their stamps from before they were read. Sent also when the scene has
// errors: saving the file that is wrong is what mends it.
struct FilesRead {
    static constexpr const char* kKind = "files_read";
    std::map<std::string, FileStamp> files; // by path
    static void fields(auto& self, auto&& field) { field("files", self.files); }
};

// What kernels printed in one pass.
struct Prints {
    static constexpr const char* kKind = "prints";
    std::vector<std::string> lines;
    std::uint64_t lost = 0; // lines that found no room

    static void fields(auto& self, auto&& field) {
        field("lines", self.lines);
        field("lost", self.lost);
    }
};

struct StageInfo {
    std::string name;
    double seconds = 0; // in the last pass
    std::uint64_t dispatches = 0;

    static void fields(auto& self, auto&& field) {
        field("name", self.name);
        field("seconds", self.seconds);
        field("dispatches", self.dispatches);
    }
};

struct PictureInfo {
    std::uint64_t id = 0; // given by the server: differs between any two pictures
    std::uint32_t revision = 0;
    int width = 0;
    int height = 0;
    bool isPreview = false;
    std::uint32_t passes = 0;
    std::uint32_t ofPasses = 0;
    std::optional<double> error;     // estimated, see docs/metrics.md
    std::vector<std::string> layers; // names of those after the picture itself
    std::vector<StageInfo> stages;
    std::uint64_t photonsStored = 0;
    std::uint64_t causticPhotonsStored = 0;
    double radius = 0; // search radius of the first pass [m]
    std::vector<std::string> warnings;

    static void fields(auto& self, auto&& field) {
        field("id", self.id);
        field("revision", self.revision);
        field("width", self.width);
        field("height", self.height);
        field("preview", self.isPreview);
        field("passes", self.passes);
        field("of_passes", self.ofPasses);
        field("error", self.error);
        field("layers", self.layers);
        field("stages", self.stages);
        field("photons_stored", self.photonsStored);
        field("caustic_photons_stored", self.causticPhotonsStored);
        field("radius", self.radius);
        field("warnings", self.warnings);
    }
};

// Pixels: of the picture, then of each layer, rows of three floats.
struct PictureRendered {
    static constexpr const char* kKind = "picture";
    PictureInfo info;
    std::vector<std::byte> pixels;
    static void fields(auto& self, auto&& field) { field("info", self.info); }
};

// Answers InspectPixel.
struct InspectedPath {
    static constexpr const char* kKind = "inspected_path";
    std::uint64_t request = 0;
    std::optional<std::string> error; // why there is no path
    Json path;                        // see path_json.h

    static void fields(auto& self, auto&& field) {
        field("request", self.request);
        field("error", self.error);
        field("path", self.path);
    }
};

// Nothing is left to do after this change.
struct WorkDone {
    static constexpr const char* kKind = "work_done";
    std::uint64_t change = 0;
    static void fields(auto& self, auto&& field) { field("change", self.change); }
};

using WorkerMessage = std::variant<KernelCompiled, KernelsProved, Errors, SceneInfo, FilesRead, Prints, PictureRendered,
                                   InspectedPath, WorkDone>;

// ---- on the wire -------------------------------------------------------------------------------------------------

// Returns false when the other side is gone.
template <class Message>
bool send(Channel& channel, const Message& message) {
    Json body = message;
    body["kind"] = Message::kKind;
    if constexpr (requires { message.pixels; }) {
        return channel.send(body, message.pixels);
    } else {
        return channel.send(body);
    }
}

// Throws Error(BadInput) when the kind is unknown, a key is missing or a value has the wrong type.
[[nodiscard]] ServerMessage readServerMessage(Packet packet);
[[nodiscard]] WorkerMessage readWorkerMessage(Packet packet);

} // namespace hyalite::live
