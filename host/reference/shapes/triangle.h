// Watertight line-triangle intersection [Woop13]: both triangles of an edge give the same result for it, so that no ray
// slips between them, and a line leaves a closed mesh as often as it enters it.
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

// A line with axes permuted so that its largest component comes last, ready to be sheared onto that axis.
class ShearedLine {
public:
    explicit ShearedLine(const Ray& ray);

    struct Meeting {
        double t = 0; // anywhere on the line [m]
        double u = 0; // weight of the second corner
        double v = 0; // weight of the third corner
        bool fromFront = false;
    };
    // Edges belong to both triangles: a line through an edge meets at least one of the two.
    [[nodiscard]] std::optional<Meeting> meetClosed(const Triangle& triangle) const;
    // A line through an edge or a corner meets what a line displaced by an infinitesimal (e, e^2) in the sheared plane
    // meets. The displacement is the same for every triangle, so each edge counts for exactly one of its two triangles.
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
