// Solids: shapes with an inside, which can be leaves of a CSG tree.
#pragma once

#include "reference/shapes/geometry.h"
#include "reference/shapes/instance.h"
#include "reference/shapes/quadric.h"
#include "reference/shapes/torus.h"

#include <optional>
#include <variant>

namespace hyalite::reference {

using Solid = std::variant<Sphere, Plane, WorldQuadric, WorldTorus, Instance>;

// The nearest hit on the solid's surface, from either side, or any hit.
[[nodiscard]] std::optional<ShapeHit> intersectSolid(const Ray& ray, const Solid& solid, Wanted wanted);

// The complete list (see Crossing), strictly ascending in t: empty intervals and gaps are removed.
[[nodiscard]] Crossings crossingsOf(const Solid& solid, const Ray& line);

[[nodiscard]] bool isInsideOf(const Solid& solid, const glm::dvec3& point);

[[nodiscard]] SurfacePoint surfaceOf(const Solid& solid, const Ray& ray, const ShapeHit& hit);

} // namespace hyalite::reference
