// Every setting of `camera` and `render`, one row each. All code that reads, checks, documents, compares or shows
// settings uses these rows: the parser, --set and the options for single keys, the JSON schema, the tables of
// docs/scene-format.md, the fingerprints of checkpoints and photon map files, and the page of `hyalite live`. To add a
// setting, add a member to its struct (scene/model/scene.h) and a row.
#pragma once

#include "scene/model/integrators.h"
#include "scene/model/scene.h"
#include "scene/yaml/key_doc.h"

#include <span>
#include <string>
#include <string_view>

namespace hyalite {

// The parts of a Scene that hold settings: what the rows read and write.
struct Settings {
    Camera camera;
    RenderSettings render;
};

enum class Section { Camera, Render };

// Whether a change of the setting changes how photons are traced.
enum class PhotonsDepend { No, OnValue, OnWhetherZero };

struct Setting {
    Section section = Section::Render;
    KeyDoc doc = {};                           // type and default come from the member of the struct
    std::string_view option = {};              // command line option, e.g. --photons; empty: only --set
    std::string_view label = {};               // label on the page of `hyalite live`; empty: not shown there
    bool affectsPicture = true;                // a checkpoint resumes only with the same value
    PhotonsDepend photons = PhotonsDepend::No; // photon maps load only with the same value

    // Overwrites the struct's member with the value. Throws Error(BadInput) at the value's place.
    void (*read)(const Value& value, const KeyDoc& doc, Settings& settings) = nullptr;
    // The value as a scene file writes it; a number is the shortest text that reads back the same. "" for no file.
    std::string (*text)(const Settings& settings) = nullptr;
};

// All settings, in the order of the documentation.
[[nodiscard]] std::span<const Setting> settingsTable();

[[nodiscard]] std::string_view nameOf(Section section);       // "camera" or "render"
[[nodiscard]] std::string dottedName(const Setting& setting); // as --set takes it: "render.photons"

// The sampler's name in a scene file.
[[nodiscard]] std::string nameOf(RandomNumbers sampler);

// The valid depths for this integrator: a subset of the range of render.max_depth.
[[nodiscard]] const Range& depthRange(const IntegratorRow& integrator);

} // namespace hyalite
