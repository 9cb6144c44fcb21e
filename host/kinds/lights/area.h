// Light from the surface of an object: its keys `emission` and `photon_share`.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite::kinds {

struct Emission {
    glm::dvec3 radiance{0};                    // of the front [W/(m^2 sr)]
    double photonShare = 1;                    // weight of the power in the choice of lights
    std::optional<Value> where = std::nullopt; // of the key `emission`; none: it is not written
};

// The two keys of an object. Throws Error(BadInput).
[[nodiscard]] Emission readEmission(Reader& reader);

// Throws Error(BadInput) at `emission` where an object of this shape cannot emit: spheres that a transform has made
// ellipsoids cannot.
void checkEmission(const Value& emission, const Shape& shape, const Scene& scene);

} // namespace hyalite::kinds
