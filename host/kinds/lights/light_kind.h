// A light type as one row: its description for the scene file, its reader, its device records and the matching light of
// the reference. One file per type; light_kinds.h lists them.
#pragma once

#include "kinds/lights/light_table.h"
#include "kinds/read_key.h"
#include "reference/lights/lights.h"
#include "scene/model/scene.h"
#include "scene/model/scene_limits.h"
#include "scene/yaml/key_doc.h"
#include "scene/yaml/reader.h"

#include <filesystem>
#include <optional>
#include <variant>

namespace hyalite::kinds {

struct LightKind {
    MapDoc doc; // empty type: not an item of `lights` but the keys that make an object a light

    // Reads one item of `lights` and adds it to the scene; paths are relative to `folder`. It may instead add lights of
    // other kinds; then the members below are null. Null itself if the kind is not an item of `lights`.
    // Throws Error(BadInput).
    void (*read)(Reader& reader, const std::filesystem::path& folder, Scene& scene) = nullptr;

    // Appends the records of the scene's lights of this kind, in the scene's order. Throws Error(BadInput).
    void (*addRecords)(const Scene& scene, LightTable& table) = nullptr;

    // Index of its type in the variant reference::Light::shape.
    std::optional<std::size_t> reference = std::nullopt;
};

// Index of the type in the variant of the reference's lights.
template <class Shape, std::size_t at = 0>
[[nodiscard]] constexpr std::size_t referenceLight() {
    using Shapes = decltype(reference::Light::shape);
    if constexpr (std::is_same_v<std::variant_alternative_t<at, Shapes>, Shape>) {
        return at;
    } else {
        return referenceLight<Shape, at + 1>();
    }
}

// Ranges of light strengths.
inline constexpr Range kIntensity{0, kLargestEmission, true, true, "W/sr"};
inline constexpr Range kIrradiance{0, kLargestEmission, true, true, "W/m^2"};
inline constexpr Range kRadiance{0, kLargestEmission, true, true, "W/(m^2 sr)"};

// Every light and every emitting object has this key.
inline constexpr KeyDoc kPhotonShare{.name = "photon_share",
                                     .range = {1e-3, 1e3},
                                     .defaultText = "1",
                                     .text = "factor of the light's weight where lights are picked: 2 about doubles "
                                             "its share of photons and light samples"};

// Reports a light that emits nothing.
[[noreturn]] inline void failDark(const Value& where, const KeyDoc& key) {
    where.fail("this light emits nothing", "give it an " + std::string(key.name) + " above 0 or remove it");
}

// Reads the strength of a light: a colour that is not black.
inline void readStrength(Reader& reader, const KeyDoc& key, glm::dvec3& out) {
    readKey(reader, key, out);
    if (out == glm::dvec3(0)) {
        failDark(reader.require(key.name), key);
    }
}

} // namespace hyalite::kinds
