// One ray against the elementary shapes, in double precision and without cancellation.
#pragma once

#include "reference/shapes/ray.h"
#include "scene/model/scene.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite::reference {

[[nodiscard]] std::optional<ShapeHit> intersectSphere(const Ray& ray, const Sphere& sphere); // nearest; [Haines19]
[[nodiscard]] std::optional<ShapeHit> intersectPlane(const Ray& ray, const Plane& plane);
[[nodiscard]] std::optional<ShapeHit> intersectQuad(const Ray& ray, const Quad& quad);
[[nodiscard]] std::optional<ShapeHit> intersectDisk(const Ray& ray, const Disk& disk);

// Crossings of the solids: a tangent line enters and leaves a sphere at the same t.
[[nodiscard]] Crossings crossings(const Sphere& sphere, const Ray& line);
[[nodiscard]] Crossings crossings(const Plane& plane, const Ray& line); // the half-space behind

[[nodiscard]] bool isInside(const Sphere& sphere, const glm::dvec3& point);
[[nodiscard]] bool isInside(const Plane& plane, const glm::dvec3& point);

[[nodiscard]] SurfacePoint surfaceAt(const Sphere& sphere, const Ray& ray, const ShapeHit& hit);
[[nodiscard]] SurfacePoint surfaceAt(const Plane& plane, const Ray& ray, const ShapeHit& hit);
[[nodiscard]] SurfacePoint surfaceAt(const Quad& quad, const Ray& ray, const ShapeHit& hit);
[[nodiscard]] SurfacePoint surfaceAt(const Disk& disk, const Ray& ray, const ShapeHit& hit);

} // namespace hyalite::reference
