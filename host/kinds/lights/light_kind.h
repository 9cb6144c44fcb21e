// A type of light in one row: what it is in the scene file, how it is read, its records on the device and which light
// of the reference it is. One file a type; the list is light_kinds.h.
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
    MapDoc doc; // no type: no item of `lights` but what makes an object a light

    // One item of `lights`, added to the scene; paths are relative to `folder`. It may add lights of other kinds: then
    // the members below are empty. Null for what is no item of `lights`. Throws Error(BadInput).
    void (*read)(Reader& reader, const std::filesystem::path& folder, Scene& scene) = nullptr;

    // Appends the records of the scene's lights of this kind, in the scene's order. Throws Error(BadInput).
    void (*addRecords)(const Scene& scene, LightTable& table) = nullptr;

    // Index of its type in the variant reference::Light::shape.
    std::optional<std::size_t> reference = std::nullopt;
};

// Where the type stands in the variant of the reference's lights.
template <class Shape, std::size_t at = 0>
[[nodiscard]] constexpr std::size_t referenceLight() {
    using Shapes = decltype(reference::Light::shape);
    if constexpr (std::is_same_v<std::variant_alternative_t<at, Shapes>, Shape>) {
        return at;
    } else {
        return referenceLight<Shape, at + 1>();
    }
}

// Ranges of what lights emit.
inline constexpr Range kIntensity{0, kLargestEmission, true, true, "W/sr"};
inline constexpr Range kIrradiance{0, kLargestEmission, true, true, "W/m^2"};
inline constexpr Range kRadiance{0, kLargestEmission, true, true, "W/(m^2 sr)"};

// Every light has this key, objects that emit too.
inline constexpr KeyDoc kPhotonShare{.name = "photon_share",
                                     .range = {1e-3, 1e3},
                                     .defaultText = "1",
                                     .text = "weight of the power in the choice of lights: 2 doubles the light's share "
                                             "of photons and light samples"};

// A light without light is a mistake.
[[noreturn]] inline void failDark(const Value& where, const KeyDoc& key) {
    where.fail("this light is dark", "give it an " + std::string(key.name) + " above 0 or leave it out");
}

// The strength of a light: a colour that is not black.
inline void readStrength(Reader& reader, const KeyDoc& key, glm::dvec3& out) {
    readKey(reader, key, out);
    if (out == glm::dvec3(0)) {
        failDark(reader.require(key.name), key);
    }
}

} // namespace hyalite::kinds
