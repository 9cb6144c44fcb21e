// Specular paths from the camera [Whitted80]; radiance is scaled by the square of the relative index when it crosses
// a boundary, so that L / n^2 is conserved.
#include "reference/shading.h"

#include "reference/materials.h"
#include "reference/medium.h"
#include "reference/sampling.h"
#include "reference/texture.h"

#include <algorithm>
#include <numbers>

namespace hyalite::reference {

namespace {

NextRay follow(const Surface& surface, const glm::dvec3& direction, const glm::dvec3& beta, std::uint32_t samplerSeed) {
    return {.ray = {.origin = leave(surface, direction), .direction = direction},
            .path = {.beta = beta, .samplerSeed = samplerSeed, .medium = nullptr}};
}

// Both ways of a camera path at glass: [0] reflected with weight F, [1] refracted with (1 - F) (n_i / n_t)^2.
std::array<std::optional<NextRay>, 2> splitAtDielectric(const Surface& surface, const glm::dvec3& direction, double eta,
                                                        double F, const CameraPath& path) {
    std::array<std::optional<NextRay>, 2> next;
    next[0] =
        follow(surface, reflect(direction, surface.normal), path.beta * F, shared::hashCombine(path.samplerSeed, 1));
    if (const auto refracted = refract(direction, surface.normal, eta)) {
        next[1] =
            follow(surface, *refracted, path.beta * ((1 - F) * eta * eta), shared::hashCombine(path.samplerSeed, 2));
    }
    return next;
}

// One of the two, picked with probability F: the weights F / F and (1 - F) / (1 - F) cancel.
std::array<std::optional<NextRay>, 2> pickAtDielectric(const Surface& surface, const glm::dvec3& direction, double eta,
                                                       double F, const CameraPath& path, double x) {
    std::array<std::optional<NextRay>, 2> next;
    if (x < F) {
        next[0] = follow(surface, reflect(direction, surface.normal), path.beta, path.samplerSeed);
    } else if (const auto refracted = refract(direction, surface.normal, eta)) {
        next[1] = follow(surface, *refracted, path.beta * (eta * eta), path.samplerSeed);
    }
    return next;
}

// What is reflected stays in the medium; what is refracted enters the dielectric at its front and leaves it at its
// back.
void setMedia(std::array<std::optional<NextRay>, 2>& next, const Surface& surface, const Material* medium) {
    if (next[0]) {
        next[0]->path.medium = medium;
    }
    if (next[1]) {
        next[1]->path.medium = surface.front ? surface.material : nullptr;
    }
}

void dropLightweights(std::array<std::optional<NextRay>, 2>& next, double minWeight) {
    for (std::optional<NextRay>& ray : next) {
        if (ray && std::max({ray->path.beta.x, ray->path.beta.y, ray->path.beta.z}) < minWeight) {
            ray.reset();
        }
    }
}

} // namespace

CameraPath beginCameraPath(const World& world, std::uint32_t pixel, std::uint32_t pass) {
    return {.beta = glm::dvec3(1),
            .samplerSeed = shared::cameraSampler(world.render.seed, pass, pixel).seed,
            .medium = nullptr};
}

Shading shadeSurface(const World& world, const Ray& ray, const Hit& hit, const CameraPath& started, std::uint32_t depth,
                     std::uint32_t pass) {
    const Surface surface = evaluateSurface(world, ray, hit);
    CameraPath path = started;
    path.beta *= transmittance(path.medium, hit.t);
    Shading shading{.emitted = path.beta * surface.emission, .visible = {}, .next = {}};
    if (surface.material == nullptr) {
        return shading;
    }
    const MaterialModel model = texturedModel(world, surface);
    if (const auto* diffuse = std::get_if<Diffuse>(&model)) {
        shading.visible = VisiblePoint{.position = surface.position,
                                       .shadowOrigin = leave(surface, surface.geometricNormal),
                                       .normal = surface.normal,
                                       .geometricNormal = surface.geometricNormal,
                                       .f = path.beta * diffuse->albedo / std::numbers::pi,
                                       .depth = depth,
                                       .samplerSeed = path.samplerSeed};
        return shading;
    }
    // ppm limits the segments of the path, whitted the bounces between them.
    const bool whitted = world.render.integrator == Integrator::Whitted;
    const std::uint32_t maxSegments = world.render.maxDepth + (whitted ? 1 : 0);
    if (depth >= maxSegments) {
        return shading;
    }
    if (const auto* mirror = std::get_if<Mirror>(&model)) {
        shading.next[0] =
            follow(surface, reflect(ray.direction, surface.normal), path.beta * mirror->reflectance, path.samplerSeed);
    } else if (const auto* glass = std::get_if<Dielectric>(&model)) {
        const double eta = surface.front ? 1 / glass->ior : glass->ior; // n_i / n_t along the ray
        const double F = fresnelDielectric(incidentCosine(ray.direction, surface.normal), eta);
        if (whitted) {
            shading.next = splitAtDielectric(surface, ray.direction, eta, F, path);
        } else {
            const shared::Sampler sampler{.seed = path.samplerSeed, .index = pass};
            const double x = sampleUnitSquare(sampler, shared::cameraScatter(depth - 1)).x;
            shading.next = pickAtDielectric(surface, ray.direction, eta, F, path, x);
        }
    }
    setMedia(shading.next, surface, path.medium);
    if (whitted) {
        dropLightweights(shading.next, world.render.minWeight);
    }
    return shading;
}

} // namespace hyalite::reference
