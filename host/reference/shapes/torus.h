// The torus, a quartic along a line: Aberth's iteration finds all roots at once [Aberth73]; the signs between them
// determine which are crossings, and these are refined on the distance from the tube itself.
#pragma once

#include "reference/shapes/affine.h"
#include "reference/shapes/ray.h"
#include "scene/model/scene.h"

#include <glm/glm.hpp>

namespace hyalite::reference {

struct WorldTorus {
    explicit WorldTorus(const Torus& torus) : major(torus.major), minor(torus.minor), map(torus.objectToWorld) {}

    double major; // object space
    double minor;
    Affine map;
};

// The complete list; a tangent line does not cross the torus.
[[nodiscard]] Crossings crossings(const WorldTorus& torus, const Ray& line);
[[nodiscard]] bool isInside(const WorldTorus& torus, const glm::dvec3& point);
[[nodiscard]] SurfacePoint surfaceAt(const WorldTorus& torus, const Ray& ray, const ShapeHit& hit);

} // namespace hyalite::reference
