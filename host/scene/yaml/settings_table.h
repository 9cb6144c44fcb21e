// Every setting of `camera` and `render`, one row each. What reads, checks, documents, compares or shows settings goes
// through these rows: the parser, --set and the options that stand for a key, the JSON schema and the tables of
// docs/scene-format.md, what a checkpoint and a file of photon maps depend on, and the page of `hyalite live`. A new
// setting is a member of its struct (scene/model/scene.h) and a row.
#pragma once

#include "scene/model/integrators.h"
#include "scene/model/scene.h"
#include "scene/yaml/key_doc.h"

#include <span>
#include <string>
#include <string_view>

namespace hyalite {

// What the rows are about: the parts of a Scene that hold settings.
struct Settings {
    Camera camera;
    RenderSettings render;
};

enum class Section { Camera, Render };

// Whether photons are traced differently when a setting changes.
enum class PhotonsDepend { No, OnValue, OnWhetherZero };

struct Setting {
    Section section = Section::Render;
    KeyDoc doc = {};                           // type and default come from the member of the struct
    std::string_view option = {};              // on the command line, e.g. --photons; empty: only --set
    std::string_view label = {};               // on the page of `hyalite live`; empty: not shown there
    bool affectsPicture = true;                // a checkpoint is resumed only with the same value
    PhotonsDepend photons = PhotonsDepend::No; // photon maps are loaded only with the same value

    // Reads the value over what the struct holds. Throws Error(BadInput) at the value's place.
    void (*read)(const Value& value, const KeyDoc& doc, Settings& settings) = nullptr;
    // The value as a scene file has it, numbers in the shortest text that reads back the same; "" for no file.
    std::string (*text)(const Settings& settings) = nullptr;
};

// All settings, in the order of the documentation.
[[nodiscard]] std::span<const Setting> settingsTable();

[[nodiscard]] std::string_view nameOf(Section section);       // "camera" or "render"
[[nodiscard]] std::string dottedName(const Setting& setting); // as --set takes it: "render.photons"

// As in a scene file.
[[nodiscard]] std::string nameOf(RandomNumbers sampler);

// The depths that suit the integrator: a part of the range of render.max_depth.
[[nodiscard]] const Range& depthRange(const IntegratorRow& integrator);

} // namespace hyalite
