// Specular paths from the camera [Whitted80]; at a boundary radiance is scaled by the square of the relative index, so
// that L / n^2 is conserved.
#include "reference/integrators/shading.h"

#include "reference/bsdf/bsdf.h"
#include "reference/bsdf/interface.h"
#include "reference/lib/sampling.h"
#include "reference/lights/light_choice.h"
#include "reference/lights/receiver.h"
#include "reference/media/boundary.h"
#include "reference/textures/texture.h"
#include "scene/model/render_seed.h"
#include "shaders/shared/limits.h"

#include <algorithm>

namespace hyalite::reference {

namespace {

NextRay follow(const Boundary& surface, const BsdfSample& sample, const CameraPath& path, std::uint32_t samplerSeed) {
    return {.ray = {.origin = leave(surface, sample.direction), .direction = sample.direction},
            .path = {.beta = path.beta * sample.weight,
                     .samplerSeed = samplerSeed,
                     .media = sample.through ? surface.beyond : path.media,
                     .pdfW = sample.pdfW}};
}

// Reflected and refracted ray of a camera path at smooth glass: [0] weighted by F, [1] by (1 - F) (n_i / n_t)^2.
std::array<std::optional<NextRay>, 2> splitAtDielectric(const Boundary& surface, const glm::dvec3& direction,
                                                        const Lobe& lobe, const CameraPath& path) {
    const double F = facetReflectance(lobe, incidentCosine(direction, surface.normal)).x;
    const double eta = lobe.eta;
    std::array<std::optional<NextRay>, 2> next;
    next[0] = follow(surface, {.direction = reflect(direction, surface.normal), .weight = glm::dvec3(F)}, path,
                     shared::deriveSequence(path.samplerSeed, 1));
    if (const auto refracted = refract(direction, surface.normal, eta)) {
        next[1] = follow(surface, {.direction = *refracted, .weight = glm::dvec3((1 - F) * eta * eta), .through = true},
                         path, shared::deriveSequence(path.samplerSeed, 2));
    }
    return next;
}

// Predicts the ray that a path reflected inside glass has beyond the next face. The face is assumed to be that of a
// ball or, for every other shape, of a pane, at the distance `chord` [m] of the last segment.
std::optional<Ray> afterNextFace(const Surface& surface, const glm::dvec3& reflection, double chord, bool isBall,
                                 double eta) {
    const glm::dvec3 normal =
        isBall ? surface.normal - 2 * glm::dot(surface.normal, reflection) * reflection : -surface.normal;
    const auto refracted = refract(reflection, normal, eta);
    return refracted ? std::optional(Ray{.origin = surface.position + chord * reflection, .direction = *refracted})
                     : std::nullopt;
}

// Probability that a path is reflected at smooth glass: the Fresnel reflectance. If only one of reflection and
// refraction leads to a light, that one gets at least kShareToLight; outside the glass only the reflection is tested.
double reflectionProbability(const World& world, const Surface& surface, const Ray& ray, const Hit& hit,
                             const Lobe& lobe, double F) {
    if (F == 0 || F == 1 || world.lights.size() > shared::kMostLightsSought) {
        return F;
    }
    const auto leadsToLight = [&](const std::optional<Ray>& way) {
        return way && std::ranges::any_of(world.lights, [&](const Light& light) {
                   return looksAt(light, way->origin, way->direction);
               });
    };
    constexpr double share{shared::kShareToLight};
    const glm::dvec3 reflection = reflect(ray.direction, surface.normal);
    if (surface.front || lobe.material.thin != 0) {
        return leadsToLight(Ray{.origin = surface.position, .direction = reflection}) ? std::max(F, share) : F;
    }
    const double eta = lobe.eta;
    const bool isBall = std::holds_alternative<Sphere>(world.objects[hit.object].shape);
    const bool reflects = leadsToLight(afterNextFace(surface, reflection, hit.t, isBall, eta));
    const glm::dvec3 refraction = refract(ray.direction, surface.normal, eta).value();
    const bool refracts = leadsToLight(Ray{.origin = surface.position, .direction = refraction});
    if (reflects == refracts) {
        return F;
    }
    return reflects ? std::max(F, share) : std::min(F, 1 - share);
}

// Follows reflection or refraction at smooth glass; the weight is whatever the selection probability does not cancel.
NextRay pickAtDielectric(const World& world, const Boundary& surface, const Ray& ray, const Hit& hit, const Lobe& lobe,
                         const CameraPath& path, double choice) {
    const double F = facetReflectance(lobe, incidentCosine(ray.direction, surface.normal)).x;
    const double eta = lobe.eta;
    const double probability = reflectionProbability(world, surface, ray, hit, lobe, F);
    if (choice < probability) {
        const glm::dvec3 reflection = reflect(ray.direction, surface.normal);
        return follow(surface, {.direction = reflection, .weight = glm::dvec3(F / probability)}, path,
                      path.samplerSeed);
    }
    return follow(surface,
                  {.direction = refract(ray.direction, surface.normal, eta).value(),
                   .weight = glm::dvec3((1 - F) / (1 - probability) * eta * eta),
                   .through = true},
                  path, path.samplerSeed);
}

void dropLightweights(std::array<std::optional<NextRay>, 2>& next, double minWeight) {
    for (std::optional<NextRay>& ray : next) {
        if (ray && std::max({ray->path.beta.x, ray->path.beta.y, ray->path.beta.z}) < minWeight) {
            ray.reset();
        }
    }
}

// MIS weight of the emission that a path hits. Where the path left a rough surface, next-event estimation sampled the
// lights too. `normal` is the light's at the hit, `distance` away [m].
double emissionWeight(const World& world, const Light& light, const CameraPath& path, const Ray& ray, double distance,
                      const glm::dvec3& normal) {
    if (path.pdfW == 0) {
        return 1;
    }
    const auto index = static_cast<std::uint32_t>(&light - world.lights.data());
    const double pmf = world.cameraPaths.followsAllWays ? 1 : pickProbability(world, index, ray.origin);
    return powerHeuristic(path.pdfW, pmf * lightPdf(light, ray.origin, ray.direction, distance, normal));
}

// Leaves by the lobe; the probability of that is already divided out of `path`.
void leaveByLobe(Shading& shading, const Boundary& surface, const Ray& ray, const Lobe& lobe, const CameraPath& path,
                 std::uint32_t depth, std::uint32_t pass, double choice) {
    glm::dvec2 uv(0);
    if (lobe.alpha > 0) {
        uv = sampleUnitSquare(shared::pathSampler(path.samplerSeed, pass), shared::cameraBounce(depth - 1));
        shading.rough = RoughPoint{.surface = surface,
                                   .lobe = lobe,
                                   .wo = -ray.direction,
                                   .beta = path.beta,
                                   .depth = depth,
                                   .samplerSeed = path.samplerSeed,
                                   .media = path.media,
                                   .beyond = surface.beyond};
    }
    const ShadingNormals normals{surface.normal, surface.geometricNormal};
    if (const auto sample = sampleLobe(lobe, normals, -ray.direction, uv, choice, Transport::Radiance)) {
        shading.next[0] = follow(surface, *sample, path, path.samplerSeed);
    }
}

VisiblePoint visibleAt(const Surface& surface, const MaterialModel& material, const glm::dvec3& wo,
                       const CameraPath& path, std::uint32_t depth) {
    return {.position = surface.position,
            .shadowOrigin = leave(surface, surface.geometricNormal),
            .normal = surface.normal,
            .geometricNormal = surface.geometricNormal,
            .wo = wo,
            .beta = path.beta,
            .material = material,
            .depth = depth,
            .samplerSeed = path.samplerSeed,
            .quad = surface.quad,
            .media = path.media,
            .disk = surface.disk};
}

} // namespace

CameraPath beginCameraPath(const World& world, std::uint32_t pixel, std::uint32_t pass) {
    return {.beta = glm::dvec3(1),
            .samplerSeed = shared::cameraSampler(renderSeed(world.render), pass, pixel).seed,
            .media = world.cameraMedia};
}

Shading shadeMiss(const World& world, const Ray& ray, const CameraPath& path) {
    Shading shading;
    const auto light = std::ranges::find_if(
        world.lights, [](const Light& candidate) { return std::holds_alternative<SurroundingLight>(candidate.shape); });
    if (light != world.lights.end()) {
        shading.emitted = path.beta * environmentRadiance(world, ray.direction) *
                          emissionWeight(world, *light, path, ray, kBeyond, glm::dvec3(0));
    }
    return shading;
}

Shading shadeSurface(const World& world, const Ray& ray, const Hit& hit, const CameraPath& started, std::uint32_t depth,
                     std::uint32_t pass) {
    const Boundary surface = boundaryAt(world, ray, hit, started.media);
    CameraPath path = started;
    path.beta *= transmittance(world.materials, path.media, hit.t);
    Shading shading{.emitted = path.beta * surface.emission, .visible = {}, .rough = {}, .next = {}};
    const auto light = std::ranges::find(world.lights, std::optional(surface.object), &Light::object);
    if (light != world.lights.end()) {
        shading.emitted *= emissionWeight(world, *light, path, ray, hit.t, surface.geometricNormal);
    }
    if (surface.material == nullptr) {
        return shading;
    }
    const MaterialModel model = relativeTo(world.materials, world.indicesFromMedia, texturedModel(world, surface),
                                           {.before = path.media, .beyond = surface.beyond, .front = surface.front});
    const bool whitted = world.cameraPaths.followsAllWays;
    const std::optional<DiffusePart> diffuse = diffusePart(model);
    const std::optional<Lobe> lobe = lobeOf(model, surface.front);
    const double cosOut = incidentCosine(ray.direction, surface.normal);
    const double probability = lobeProbability(lobe, diffuse, cosOut);
    const shared::Sampler sampler = shared::pathSampler(path.samplerSeed, pass);
    const double choice = sampleUnitSquare(sampler, shared::cameraScatter(depth - 1)).x;
    const bool both = whitted && diffuse && lobe;

    CameraPath onward = path;
    if (diffuse && (both || choice >= probability)) {
        onward.beta = path.beta / (both ? 1 : 1 - probability);
        shading.visible = visibleAt(surface, model, -ray.direction, onward, depth);
    }
    // ppm limits the number of path segments, whitted the number of bounces between them.
    const std::uint32_t maxSegments = world.render.maxDepth + (whitted ? 1 : 0);
    if (lobe && depth < maxSegments && (both || choice < probability)) {
        const PickedLobe picked = pickLobe(*lobe, cosOut, both ? choice : choice / probability);
        onward.beta = path.beta / (both ? 1 : probability) / picked.probability;
        if (lobe->alpha > 0 || !lobe->transmits) {
            leaveByLobe(shading, surface, ray, picked.lobe, onward, depth, pass, choice);
        } else if (whitted) {
            shading.next = splitAtDielectric(surface, ray.direction, *lobe, path);
        } else {
            shading.next[0] = pickAtDielectric(world, surface, ray, hit, *lobe, path, choice);
        }
    }
    if (whitted) {
        dropLightweights(shading.next, world.render.minWeight);
    }
    return shading;
}

bool seeksLight(const World& world, std::uint32_t pixel, std::uint32_t pass) {
    NextRay step{.ray = generateCameraRay(world, pixel, pass), .path = beginCameraPath(world, pixel, pass)};
    for (std::uint32_t depth = 1; depth < world.render.maxDepth; ++depth) {
        const std::optional<Hit> hit = traceClosest(world, step.ray);
        if (!hit) {
            return false;
        }
        const Shading shading = shadeSurface(world, step.ray, *hit, step.path, depth, pass);
        const bool reflects = shading.visible && receiverAt(*shading.visible).f != glm::dvec3(0);
        if (reflects || shading.rough) {
            return true;
        }
        if (!shading.next[0]) {
            return false;
        }
        step = *shading.next[0];
    }
    return false;
}

} // namespace hyalite::reference
