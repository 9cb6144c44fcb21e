// Random scenes for the audits: a closed room of 2 m with solids and sheets of every kind and material, and lights. A
// draft is kept in parts, so that a failure can be made smaller.
#pragma once

#include "transport/scene_text.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hyalite::testing {

enum class Audit {
    Lit,     // lights inside: the walls absorb no more than these send
    Furnace, // walls and objects emit what they absorb, at most: nothing is brighter than 1
    Nested,  // a furnace where solids overlap, with and without priorities
    Sealed,  // lights outside only: all is black
    Compare, // lit by areas: what ppm and path show of one wall is equal
};

// One object or light, with its material.
struct Part {
    std::string keys = {};     // of the object or light, without braces
    std::string material = {}; // value in `materials`; empty: none. The object's key is written with it
    double power = 0;          // flux that it sends into the room [W]
};

struct Draft {
    std::uint64_t number = 0;
    Audit audit = Audit::Lit;
    double albedo = 0.5; // of the walls
    std::vector<Part> objects;
    std::vector<Part> lights;
    glm::dvec3 eye{0};       // Furnace: somewhere between the objects
    glm::dvec3 direction{1}; // Furnace: of the view
    std::string settings;    // further keys of `render`, each followed by a comma

    [[nodiscard]] double power() const;      // [W]
    [[nodiscard]] std::size_t views() const; // pictures that the audit needs
    // Text of the scene file seen in view `view`: of the walls in turn, all of each (Compare: the middle of one); or
    // (Furnace) from the eye.
    [[nodiscard]] std::string scene(std::size_t view) const;
};

// The audit of this scene among many: of five two are lit, one each is a furnace, sealed and nested.
[[nodiscard]] Audit auditOf(std::uint64_t number);

// The same draft for the same number, on every machine.
[[nodiscard]] Draft draftScene(std::uint64_t number, Audit audit);

// Files that drafts name.
[[nodiscard]] const std::map<std::string, std::string>& draftFiles();

} // namespace hyalite::testing
