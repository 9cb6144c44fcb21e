#include "reference/lights/shadow.h"

#include "reference/bsdf/bsdf.h"
#include "reference/bsdf/interface.h"
#include "reference/media/boundary.h"

#include "shaders/shared/limits.h"

#include <algorithm>
#include <cmath>

namespace hyalite::reference {

namespace {

bool isMatched(double relativeIndex) {
    return std::abs(relativeIndex - 1) < double{shared::kSmoothIndex};
}

// What goes straight on at a dielectric; 0 if it refracts.
double straightShare(const MaterialModel& model, const Surface& surface, const glm::dvec3& direction) {
    if (model.type != shared::kMaterialDielectric) {
        return 0;
    }
    if (model.thin != 0) {
        const Lobe lobe = lobeOf(model, surface.front).value();
        return 1 - facetReflectance(lobe, incidentCosine(direction, surface.normal)).x;
    }
    return isMatched(model.ior) ? 1 : 0;
}

} // namespace

bool hasStraightGlass(const std::vector<Material>& materials) {
    return std::ranges::any_of(materials, [](const Material& material) {
        const MaterialModel& model = material.model;
        return model.type == shared::kMaterialDielectric &&
               (model.thin != 0 || model.priority > 0 || isMatched(model.ior));
    });
}

glm::dvec3 straightTransmittance(const World& world, const glm::dvec3& from, const glm::dvec3& to, Media media) {
    constexpr int kMostPassed = 64; // as on the device: behind more it counts as occluded
    glm::dvec3 share(1);
    const glm::dvec3 direction = glm::normalize(to - from);
    Ray ray{.origin = from, .direction = direction, .tMax = glm::length(to - from)};
    for (int passed = 0; passed < kMostPassed; ++passed) {
        const std::optional<Hit> hit = traceClosest(world, ray);
        share *= transmittance(world.materials, media, hit ? hit->t : ray.tMax);
        if (!hit) {
            return share;
        }
        const Boundary surface = boundaryAt(world, ray, *hit, media);
        if (surface.material == nullptr) {
            return glm::dvec3(0);
        }
        const MaterialModel model = relativeTo(world.materials, world.indicesFromMedia, surface.material->model,
                                               {.before = media, .beyond = surface.beyond, .front = surface.front});
        share *= straightShare(model, surface, direction);
        ray.origin = leave(surface, direction);
        ray.tMax = glm::dot(to - ray.origin, direction);
        if (share == glm::dvec3(0) || ray.tMax <= 0) {
            return share;
        }
        media = surface.beyond;
    }
    return glm::dvec3(0);
}

} // namespace hyalite::reference
