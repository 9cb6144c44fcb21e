// Where the scene file puts a shape: its place among transforms, and what every shape must pass once it stands there.
#pragma once

#include "scene/model/scene.h"
#include "scene/model/scene_limits.h"
#include "scene/yaml/reader.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite {

// Ranges of what a shape's keys hold.
inline constexpr Range kCoordinate{-kLargestLength, kLargestLength, true, true, "m"};
inline constexpr Range kLength{kSmallestLength, kLargestLength, true, true, "m"};
inline constexpr Range kDirection{-kLargestLength, kLargestLength};

struct Placement {
    glm::dmat4 objectToWorld{1};    // invertible, affine; the product of all transforms around the shape
    std::optional<Value> transform; // the innermost of them, for messages; none: there is none
};

[[nodiscard]] glm::dvec3 transformPoint(const glm::dmat4& map, const glm::dvec3& point);

// The rotation by the smallest angle that takes +y to the axis (of any length but 0); -y: half a turn about x.
[[nodiscard]] glm::dmat3 rotationFromY(const glm::dvec3& axis);

// A direction of any length but 0, made a unit vector.
[[nodiscard]] glm::dvec3 readUnit(const Value& value);

// The `axis` of a shape, +y where it is not written.
[[nodiscard]] glm::dvec3 readAxis(Reader& reader);

// The map to world space of a shape written about its own origin with y as its axis: turned, moved, transformed.
[[nodiscard]] glm::dmat4 placed(const Placement& placement, const glm::dvec3& center,
                                const glm::dvec3& axis = {0, 1, 0});

// The shape must not reach beyond the largest coordinate where it has an end, nor be squashed until its `thinnest`
// length (object space) is below the smallest. Throw Error(BadInput).
[[nodiscard]] bool isWithinReach(const Bounds& world);
void checkReach(const Reader& reader, const Bounds& world);
void checkThickness(const Placement& placement, double thinnest);

} // namespace hyalite
