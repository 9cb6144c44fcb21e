// Places shapes in the world: their transforms, and the checks that every placed shape must pass.
#pragma once

#include "scene/model/scene.h"
#include "scene/model/scene_limits.h"
#include "scene/yaml/reader.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite {

// Ranges of the keys of shapes.
inline constexpr Range kCoordinate{-kLargestLength, kLargestLength, true, true, "m"};
inline constexpr Range kLength{kSmallestLength, kLargestLength, true, true, "m"};
inline constexpr Range kDirection{-kLargestLength, kLargestLength};

struct Placement {
    glm::dmat4 objectToWorld{1};    // invertible, affine; the product of all transforms that apply to the shape
    std::optional<Value> transform; // the innermost transform, for messages; nullopt: no transform
};

[[nodiscard]] glm::dvec3 transformPoint(const glm::dmat4& map, const glm::dvec3& point);

// The rotation by the smallest angle that takes +y to the axis (any nonzero length); for -y, half a turn about x.
[[nodiscard]] glm::dmat3 rotationFromY(const glm::dvec3& axis);

// Reads a direction of any nonzero length and normalises it.
[[nodiscard]] glm::dvec3 readUnit(const Value& value);

// Reads the `axis` of a shape; +y if the key is absent.
[[nodiscard]] glm::dvec3 readAxis(Reader& reader);

// Object-to-world map of a shape centred at its origin with axis y: rotates y to `axis`, moves it to `center`, then
// applies the placement.
[[nodiscard]] glm::dmat4 placed(const Placement& placement, const glm::dvec3& center,
                                const glm::dvec3& axis = {0, 1, 0});

// Check that the finite sides of the shape's bounds lie within the largest coordinate, and that its `thinnest` length
// (object space) is still at least the smallest length after the transform. The check functions throw Error(BadInput).
[[nodiscard]] bool isWithinReach(const Bounds& world);
void checkReach(const Reader& reader, const Bounds& world);
void checkThickness(const Placement& placement, double thinnest);

} // namespace hyalite
