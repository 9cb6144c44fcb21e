// See solid.h.
#include "reference/shapes/solid.h"

#include <cmath>

namespace hyalite::reference {

std::optional<ShapeHit> intersectSolid(const Ray& ray, const Solid& solid, Wanted wanted) {
    if (const auto* sphere = std::get_if<Sphere>(&solid)) {
        return intersectSphere(ray, *sphere);
    }
    if (const auto* plane = std::get_if<Plane>(&solid)) {
        return intersectPlane(ray, *plane);
    }
    if (const auto* instance = std::get_if<Instance>(&solid)) {
        return intersectInstance(ray, *instance, wanted);
    }
    const auto* quadric = std::get_if<WorldQuadric>(&solid);
    const Crossings all = quadric != nullptr ? crossings(*quadric, ray) : crossings(std::get<WorldTorus>(solid), ray);
    for (const Crossing& crossing : all) {
        if (inRange(crossing.at.t, ray) && std::isfinite(crossing.at.t)) {
            return crossing.at;
        }
    }
    return std::nullopt;
}

Crossings crossingsOf(const Solid& solid, const Ray& line) {
    Crossings strict;
    for (const Crossing& crossing : std::visit([&](const auto& shape) { return crossings(shape, line); }, solid)) {
        if (!strict.empty() && strict.back().at.t == crossing.at.t) {
            strict.pop_back();
        } else {
            strict.push_back(crossing);
        }
    }
    return strict;
}

bool isInsideOf(const Solid& solid, const glm::dvec3& point) {
    return std::visit([&](const auto& shape) { return isInside(shape, point); }, solid);
}

SurfacePoint surfaceOf(const Solid& solid, const Ray& ray, const ShapeHit& hit) {
    return std::visit([&](const auto& shape) { return surfaceAt(shape, ray, hit); }, solid);
}

} // namespace hyalite::reference
