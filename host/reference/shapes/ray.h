// Common to all shapes: where a ray hits them, where its line crosses their surface, and how far from a surface a
// leaving ray must start.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

namespace hyalite::reference {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct Ray {
    glm::dvec3 origin;       // [m], already moved off the surface that the ray leaves
    glm::dvec3 direction;    // unit in the world; of any length in an object's own space
    double tMax = kInfinite; // the ray ends here [m]
};

// Where a ray meets a shape.
struct ShapeHit {
    double t = 0;           // [m], 0 < t <= tMax unless stated otherwise
    double u = 0;           // quad, disk: along the first edge or axis; triangle: weight of the second corner
    double v = 0;           // quad, disk: along the second edge or axis; triangle: weight of the third corner
    std::uint32_t part = 0; // which surface of the shape; quadric: 0 that of q, 1..6 the clip box's faces (low x, high
                            // x, low y, ...); mesh: the triangle, in the order of the file; 0 for other shapes
};

[[nodiscard]] inline bool inRange(double t, const Ray& ray) {
    return t > 0 && t <= ray.tMax;
}

// Where the line of a ray crosses a solid's surface. A solid's complete list covers the whole line, ascends in t, and
// alternates between entering and leaving: it starts with entering and ends with leaving. An unbounded inside is
// entered at t = -infinity or left at t = infinity.
struct Crossing {
    ShapeHit at;
    bool entering = false;
};
using Crossings = std::vector<Crossing>;

// A point on a shape's surface; normals are on its front, regardless of the side of the ray.
struct SurfacePoint {
    glm::dvec3 position;        // world [m]
    glm::dvec3 geometricNormal; // unit
    glm::dvec3 normal;          // unit, for shading
    double offset = 0;          // distance [m] from the surface at which a leaving ray starts
    glm::dvec2 uv{0};           // for textures; (0, 0) for a shape without coordinates
};

// Distance [m] by which a ray's origin is moved along the normal, away from the surface it leaves. `scale` [m] bounds
// the sum of the lengths that the point was computed from (corner and edges, centre and radius), whose rounding errors
// add up to at most 16 half-ulps of it: 8 in the point itself, 8 in the next intersection with the same shape. Four
// times that keeps the next root on the right side of zero.
[[nodiscard]] constexpr double surfaceOffset(double scale) {
    return 64 * 0x1p-53 * scale;
}

} // namespace hyalite::reference
