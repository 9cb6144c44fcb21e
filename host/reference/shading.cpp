// Specular paths from the camera [Whitted80]; radiance is scaled by the square of the relative index when it crosses
// a boundary, so that L / n^2 is conserved.
#include "reference/shading.h"

#include "reference/bsdf.h"
#include "reference/materials.h"
#include "reference/sampling.h"

#include <algorithm>
#include <numbers>

namespace hyalite::reference {

namespace {

NextRay follow(const Surface& surface, const LobeSample& sample, const CameraPath& path, std::uint32_t samplerSeed) {
    return {.ray = {.origin = leave(surface, sample.direction), .direction = sample.direction},
            .path = {.beta = path.beta * sample.weight, .samplerSeed = samplerSeed, .pdfW = sample.pdfW}};
}

// Both ways of a camera path at smooth glass: [0] reflected with weight F, [1] refracted with (1 - F) (n_i / n_t)^2.
std::array<std::optional<NextRay>, 2> splitAtDielectric(const Surface& surface, const glm::dvec3& direction, double eta,
                                                        const CameraPath& path) {
    const double F = fresnelDielectric(incidentCosine(direction, surface.normal), eta);
    std::array<std::optional<NextRay>, 2> next;
    next[0] = follow(surface, {.direction = reflect(direction, surface.normal), .weight = glm::dvec3(F)}, path,
                     shared::hashCombine(path.samplerSeed, 1));
    if (const auto refracted = refract(direction, surface.normal, eta)) {
        next[1] = follow(surface, {.direction = *refracted, .weight = glm::dvec3((1 - F) * eta * eta)}, path,
                         shared::hashCombine(path.samplerSeed, 2));
    }
    return next;
}

void dropLightweights(std::array<std::optional<NextRay>, 2>& next, double minWeight) {
    for (std::optional<NextRay>& ray : next) {
        if (ray && std::max({ray->path.beta.x, ray->path.beta.y, ray->path.beta.z}) < minWeight) {
            ray.reset();
        }
    }
}

// Light that a path finds that has left a rough surface by chance: the lights were sampled there too.
double emissionWeight(const World& world, const Surface& surface, const Ray& ray, const Hit& hit,
                      const CameraPath& path) {
    const auto light =
        std::ranges::find_if(world.lights, [&](const Light& candidate) { return candidate.object == hit.object; });
    if (path.pdfW == 0 || light == world.lights.end()) {
        return 1;
    }
    const double pmf = world.render.integrator == Integrator::Whitted ? 1 : light->pmf;
    const auto& area = std::get<AreaLight>(light->shape);
    return powerHeuristic(path.pdfW, pmf * lightPdfW(area, surface.geometricNormal, -ray.direction, hit.t));
}

// Leaves by the lobe; `path` has the probability of that divided out.
void leaveByLobe(Shading& shading, const Surface& surface, const Ray& ray, const Lobe& lobe, const CameraPath& path,
                 std::uint32_t depth, std::uint32_t pass, double choice) {
    glm::dvec2 uv(0);
    if (lobe.alpha > 0) {
        uv = sampleUnitSquare({.seed = path.samplerSeed, .index = pass}, shared::cameraBounce(depth - 1));
        shading.rough = RoughPoint{.surface = surface,
                                   .lobe = lobe,
                                   .wo = -ray.direction,
                                   .beta = path.beta,
                                   .depth = depth,
                                   .samplerSeed = path.samplerSeed};
    }
    const ShadingNormals normals{surface.normal, surface.geometricNormal};
    if (const auto sample = sampleLobe(lobe, normals, -ray.direction, uv, choice, Transport::Radiance)) {
        shading.next[0] = follow(surface, *sample, path, path.samplerSeed);
    }
}

VisiblePoint visibleAt(const Surface& surface, const DiffusePart& diffuse, const CameraPath& path, std::uint32_t depth,
                       double cosOut) {
    const glm::dvec3 f = diffuseReflectance(diffuse, cosOut, 1) / std::numbers::pi; // straight in, through any coat
    return {.position = surface.position,
            .shadowOrigin = leave(surface, surface.geometricNormal),
            .normal = surface.normal,
            .geometricNormal = surface.geometricNormal,
            .f = path.beta * f,
            .depth = depth,
            .samplerSeed = path.samplerSeed,
            .coated = diffuse.coated};
}

} // namespace

CameraPath beginCameraPath(const World& world, std::uint32_t pixel, std::uint32_t pass) {
    return {.beta = glm::dvec3(1), .samplerSeed = shared::cameraSampler(world.render.seed, pass, pixel).seed};
}

Shading shadeSurface(const World& world, const Ray& ray, const Hit& hit, const CameraPath& path, std::uint32_t depth,
                     std::uint32_t pass) {
    const Surface surface = evaluateSurface(world, ray, hit);
    Shading shading{.emitted = path.beta * surface.emission, .visible = {}, .rough = {}, .next = {}};
    shading.emitted *= emissionWeight(world, surface, ray, hit, path);
    if (surface.material == nullptr) {
        return shading;
    }
    const bool whitted = world.render.integrator == Integrator::Whitted;
    const std::optional<DiffusePart> diffuse = diffusePart(surface.material->model);
    const std::optional<Lobe> lobe = lobeOf(surface.material->model, surface.front);
    const double cosOut = incidentCosine(ray.direction, surface.normal);
    const double probability = lobeProbability(lobe, diffuse, cosOut);
    const shared::Sampler sampler{.seed = path.samplerSeed, .index = pass};
    const double choice = sampleUnitSquare(sampler, shared::cameraScatter(depth - 1)).x;
    const bool both = whitted && diffuse && lobe;

    CameraPath onward = path;
    if (diffuse && (both || choice >= probability)) {
        onward.beta = path.beta / (both ? 1 : 1 - probability);
        shading.visible = visibleAt(surface, *diffuse, onward, depth, cosOut);
    }
    // ppm limits the segments of the path, whitted the bounces between them.
    const std::uint32_t maxSegments = world.render.maxDepth + (whitted ? 1 : 0);
    if (lobe && depth < maxSegments && (both || choice < probability)) {
        onward.beta = path.beta / (both ? 1 : probability);
        if (whitted && lobe->alpha == 0 && std::holds_alternative<Dielectric>(lobe->model)) {
            shading.next = splitAtDielectric(surface, ray.direction, lobe->eta, path);
        } else {
            leaveByLobe(shading, surface, ray, *lobe, onward, depth, pass, choice);
        }
    }
    if (whitted) {
        dropLightweights(shading.next, world.render.minWeight);
    }
    return shading;
}

} // namespace hyalite::reference
