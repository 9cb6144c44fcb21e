// Light from the surface of an object: its keys `emission` and `photon_share`.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite::kinds {

struct Emission {
    glm::dvec3 radiance{0};                    // of the front [W/(m^2 sr)]
    double photonShare = 1;                    // factor of the power in light selection
    std::optional<Value> where = std::nullopt; // the key `emission`; nullopt: it is absent
};

// Reads the two keys of an object. Throws Error(BadInput).
[[nodiscard]] Emission readEmission(Reader& reader);

// Throws Error(BadInput) at `emission` if an object of this shape cannot emit; a sphere that a transform made an
// ellipsoid cannot.
void checkEmission(const Value& emission, const Shape& shape, const Scene& scene);

} // namespace hyalite::kinds
