// A line against triangles, watertight [Woop13]: what it says about an edge is the same from both of its triangles, so
// that no ray slips between them, and a closed mesh is left as often as it is entered.
#pragma once

#include "reference/shapes/ray.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

namespace hyalite::reference {

struct Triangle {
    std::array<glm::dvec3, 3> corners; // [m], counter-clockwise from the front
};

// A line with its axes turned so that it runs along its largest component, ready to be sheared onto that axis.
class ShearedLine {
public:
    explicit ShearedLine(const Ray& ray);

    struct Meeting {
        double t = 0; // anywhere on the line [m]
        double u = 0; // weight of the second corner
        double v = 0; // weight of the third corner
        bool fromFront = false;
    };
    // Edges belong to both triangles: a line through one meets at least one of them.
    [[nodiscard]] std::optional<Meeting> meetClosed(const Triangle& triangle) const;
    // A line through an edge or a corner meets what its neighbour meets, moved to the side by an infinitely small
    // (e, e^2) in the sheared plane: the same move for every triangle, so that each edge counts for one of its two.
    [[nodiscard]] std::optional<Meeting> meetOnce(const Triangle& triangle) const;

private:
    // x and y across the line, t along it
    [[nodiscard]] std::array<glm::dvec3, 3> shear(const Triangle& triangle) const;
    [[nodiscard]] std::optional<Meeting> meeting(const std::array<glm::dvec3, 3>& p, const glm::dvec3& edges) const;

    glm::dvec3 origin_;
    int kx_, ky_, kz_;
    double shearX_, shearY_;
    double along_; // the line's largest component
};

[[nodiscard]] std::optional<ShapeHit> intersectTriangle(const Ray& ray, const Triangle& triangle);

} // namespace hyalite::reference
