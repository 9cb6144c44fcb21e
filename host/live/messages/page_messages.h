// What the page asks over HTTP, and what it is answered.
#pragma once

#include "live/messages/messages.h"

#include <deque>

namespace hyalite::live {

// POST /api/change. A member without a value leaves things as they are.
struct ChangeRequest {
    std::map<std::string, std::optional<std::string>> settings; // nothing: as in the scene file
    std::optional<std::string> shown;
    std::optional<std::uint32_t> pixel;
    bool reset = false; // first go back to the settings that the server was started with

    // Whether it does no more than choose a pixel.
    [[nodiscard]] bool isPixelAlone() const { return pixel && settings.empty() && !shown && !reset; }
};

// {"settings": {key: text or null}, "shown": text, "pixel": number, "reset": true}, all of them optional. Throws
// Error(WrongUsage) that says which is of the wrong type.
[[nodiscard]] ChangeRequest readChangeRequest(const Json& json);

// POST /api/inspect.
struct PixelRequest {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    static void fields(auto& self, auto&& field) {
        field("x", self.x);
        field("y", self.y);
    }
};

// POST /api/file.
struct FileRequest {
    std::string name;
    std::string text;
    static void fields(auto& self, auto&& field) {
        field("name", self.name);
        field("text", self.text);
    }
};

// GET /api/state.
struct StateAnswer {
    std::uint64_t version = 0; // differs whenever anything else in here does
    std::uint32_t revision = 0;
    std::string name; // of the scene file
    std::optional<SceneInfo> scene;
    std::map<std::string, std::string> overrides; // settings that differ from the scene file
    std::string shown;
    std::optional<PictureInfo> picture;
    std::vector<ErrorReport> errors;
    std::deque<std::string> prints;
    std::uint64_t printCount = 0;
    std::deque<std::string> notes;
    double firstPixelSeconds = 0; // from the last change of the page to the first picture that shows it
    double reloadSeconds = 0;     // likewise of a saved file
    std::uint64_t changes = 0;    // of files, settings and view; the start is number 1
    bool isBusy = true;           // work is left to do after the last change
    bool isClosing = false;       // the server ends
    bool mayWrite = false;        // the page may save files

    static void fields(auto& self, auto&& field) {
        field("version", self.version);
        field("revision", self.revision);
        field("name", self.name);
        field("scene", self.scene);
        field("overrides", self.overrides);
        field("shown", self.shown);
        field("picture", self.picture);
        field("errors", self.errors);
        field("prints", self.prints);
        field("print_count", self.printCount);
        field("notes", self.notes);
        field("first_pixel_seconds", self.firstPixelSeconds);
        field("reload_seconds", self.reloadSeconds);
        field("changes", self.changes);
        field("busy", self.isBusy);
        field("closing", self.isClosing);
        field("may_write", self.mayWrite);
    }
};

} // namespace hyalite::live
