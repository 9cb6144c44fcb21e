// How large a scene is: axis-aligned bounds, and the lengths that rendering derives from them.
#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>
#include <limits>

namespace hyalite {

// Axis-aligned box [m]; empty until a point is added.
struct Bounds {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

// Bounds of the mesh's triangles in world space.
[[nodiscard]] Bounds meshBounds(const Mesh& mesh, const glm::dmat4& objectToWorld);

// Bounds of all objects in world space; the scene has at least one.
[[nodiscard]] Bounds sceneBounds(const Scene& scene);

// Radius of the scene's bounding sphere [m]: half the diagonal of its bounds.
[[nodiscard]] double sceneRadius(const Scene& scene);

// Search radius of the first pass [m]: render.radius or, where that is 0, 1/100 of sceneRadius.
[[nodiscard]] double initialRadius(const Scene& scene);

} // namespace hyalite
