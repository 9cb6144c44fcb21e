// See probe_path.h.
#include "scene/checks/probe_path.h"

#include "reference/bsdf/bsdf.h"
#include "reference/lib/sampling.h"

#include <cmath>

namespace hyalite::checks {
namespace {

using glm::dvec3;

dvec3 reflected(const dvec3& direction, const dvec3& normal) {
    return direction - 2 * glm::dot(direction, normal) * normal;
}

// Refracted, or totally reflected; `eta`: index on the side of the normal over that beyond.
dvec3 refracted(const dvec3& direction, const dvec3& normal, double eta) {
    const double cosIn = -glm::dot(direction, normal);
    const double sin2 = eta * eta * (1 - cosIn * cosIn);
    return sin2 >= 1 ? reflected(direction, normal) : eta * direction + (eta * cosIn - std::sqrt(1 - sin2)) * normal;
}

// The direction in which a path leaves; nullopt: the material absorbs it.
std::optional<dvec3> scatter(const ProbeVertex& vertex, bool isFront, const dvec3& direction, Dice& dice) {
    const double choice = dice.next();
    const glm::dvec2 uv = dice.pair();
    const bool hasDiffuse = (vertex.flags & shared::kBsdfDiffuse) != 0;
    const bool hasLobe = (vertex.flags & (shared::kBsdfSpecular | shared::kBsdfGlossy)) != 0;
    if (hasDiffuse && (!hasLobe || choice < 0.5)) {
        return reference::cosineHemisphere(uv, vertex.normal);
    }
    if (!hasLobe) {
        return std::nullopt;
    }
    dvec3 out = reflected(direction, vertex.normal);
    if ((vertex.flags & shared::kBsdfTransmitting) != 0 && choice < 0.7) {
        const double ior = vertex.material->model.thin != 0 ? 1 : vertex.material->model.ior;
        out = refracted(direction, vertex.normal, isFront ? 1 / ior : ior);
    }
    if ((vertex.flags & shared::kBsdfGlossy) != 0) { // rough: any direction on the same side
        const double side = glm::dot(out, vertex.normal) >= 0 ? 1.0 : -1.0;
        out = reference::cosineHemisphere(uv, side * vertex.normal);
    }
    return out;
}

} // namespace

bool isSpecular(const Material& material) {
    const std::uint32_t flags = reference::bsdfFlags(material.model);
    const bool isStraight =
        material.model.type == shared::kMaterialDielectric && (material.model.ior == 1 || material.model.thin != 0);
    return (flags & shared::kBsdfSpecular) != 0 && (flags & (shared::kBsdfDiffuse | shared::kBsdfGlossy)) == 0 &&
           !isStraight;
}

ProbePath follow(const reference::World& world, reference::Ray ray, int most, Dice& dice) {
    ProbePath path;
    bool onlySpecular = true;
    bool anySpecular = false;
    for (int i = 0; i < most; ++i) {
        const auto hit = reference::traceClosest(world, ray);
        if (!hit) {
            path.escapes = true;
            break;
        }
        const reference::Surface surface = reference::evaluateSurface(world, ray, *hit);
        ProbeVertex vertex{.position = reference::leave(surface, -ray.direction),
                           .normal = surface.geometricNormal,
                           .object = hit->object,
                           .material = surface.material};
        vertex.flags = surface.material != nullptr ? reference::bsdfFlags(surface.material->model) : 0;
        vertex.isAfterSpecular = onlySpecular && anySpecular;
        vertex.isLit = surface.emission != dvec3(0);
        path.vertices.push_back(vertex);
        const bool passesOn =
            vertex.material != nullptr &&
            (isSpecular(*vertex.material) || vertex.material->model.type == shared::kMaterialDielectric);
        if (passesOn) {
            anySpecular = anySpecular || isSpecular(*vertex.material);
            onlySpecular = onlySpecular && (vertex.flags & shared::kBsdfGlossy) == 0;
        } else {
            onlySpecular = false;
        }
        const std::optional<dvec3> out = scatter(vertex, surface.front, ray.direction, dice);
        if (!out) {
            break;
        }
        ray = {.origin = reference::leave(surface, *out), .direction = *out};
    }
    return path;
}

} // namespace hyalite::checks
