// First pass: photons. Second pass: direct light by shadow rays, caustics from the caustic map, indirect light by final
// gathering from the global map or, without gather rays, from the global map at the visible point [Jensen96].
#include "reference/integrators/photon_mapping.h"

#include "base/parallel.h"
#include "geometry/light_use.h"
#include "geometry/search_radius.h"
#include "reference/integrators/shading.h"
#include "reference/lib/sampling.h"
#include "reference/lights/receiver.h"
#include "reference/photons/photons.h"
#include "reference/photons/radiance_estimate.h"
#include "reference/photons/shadow_photons.h"
#include "scene/model/render_seed.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace hyalite::reference {

namespace {

using std::numbers::pi;

PhotonMap traceGlobalMap(const World& world) {
    return PhotonMap(
        tracePhotons(world, {.sequence = shared::photonSequence(renderSeed(world.render), shared::kGlobalPhotons, 0),
                             .count = world.render.photons,
                             .kinds = kGlobalKinds}));
}

std::optional<PhotonMap> traceCausticMap(const World& world) {
    const PhotonMapSettings& settings = world.render.photonMap;
    if (settings.causticPhotons == 0 || world.targets.empty()) {
        return std::nullopt;
    }
    return PhotonMap(
        tracePhotons(world, {.sequence = shared::photonSequence(renderSeed(world.render), shared::kCausticPhotons, 0),
                             .count = settings.causticPhotons,
                             .kinds = kindBit(PhotonKind::Caustic),
                             .aimed = settings.projectionMap}));
}

double largestEstimate(const World& world, const PhotonMap& map, std::size_t nearest, double largest,
                       double footprint) {
    std::vector<glm::dvec3> positions;
    for (const Photon& photon : map.photons()) {
        positions.push_back(photon.position);
    }
    return largestEstimateFor(nearest, positions, largest, {.eye = world.camera.position, .footprint = footprint});
}

// The irradiance at every fourth photon of the global map [Christensen99].
PhotonMap computeIrradiance(const World& world, const PhotonMap& global, double radius) {
    std::vector<Photon> records;
    for (const Photon& photon : global.photons()) {
        if ((photon.photon + photon.depth) % 4 == 0) {
            records.push_back(photon);
        }
    }
    parallelFor(records.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const VisiblePoint x{.position = records[i].position,
                                 .shadowOrigin = records[i].position,
                                 .normal = records[i].normal,
                                 .geometricNormal = records[i].normal,
                                 .wo = records[i].normal,
                                 .beta = glm::dvec3(1),
                                 .depth = 1,
                                 .samplerSeed = 0};
            const RadianceEstimate estimate = estimateRadiance(global, x, globalOptions(world, radius, kGlobalKinds));
            records[i].power = estimate.radiance;
            records[i].discRadius = estimate.radius;
        }
    });
    return PhotonMap(std::move(records));
}

// All light reflected by the diffuse surface that a gather ray hits.
glm::dvec3 lookUp(const World& world, const PhotonMaps& maps, const VisiblePoint& y) {
    const std::optional<glm::dvec3> E =
        maps.irradiance ? recordedIrradiance(*maps.irradiance, y, maps.globalRadius, world.surfaceError) : std::nullopt;
    if (!E) {
        return estimateRadiance(maps.global, y, globalOptions(world, maps.globalRadius, kGlobalKinds)).radiance;
    }
    // Irradiance has no direction: treat it as uniform illumination
    const Receiver receiver = receiverAt(y);
    return receiver.f * *E * receiver.meanIncident();
}

// One gather ray contributes f cos / pdf = f pi times the radiance it finds. Emission it sees directly is direct light,
// and emission it sees via mirrors, glass or rough surfaces belongs to the caustics: neither counts here.
glm::dvec3 finalGather(const World& world, const PhotonMaps& maps, const VisiblePoint& x, std::uint32_t pass) {
    const std::uint32_t rays = world.render.photonMap.gatherRays;
    const Receiver receiver = receiverAt(x);
    glm::dvec3 L(0);
    for (std::uint32_t ray = 0; ray < rays; ++ray) {
        const std::uint32_t gather = shared::gatherPass(pass, rays, ray);
        const shared::Sampler sampler = shared::pathSampler(shared::gatherSequence(x.samplerSeed), gather);
        const glm::dvec3 direction = cosineHemisphere(sampleUnitSquare(sampler, shared::kGatherDirection), x.normal);
        if (glm::dot(direction, x.geometricNormal) <= 0) {
            continue;
        }
        followPath(world, {.origin = x.shadowOrigin, .direction = direction},
                   {.beta = receiver.f * (pi * receiver.incident(glm::dot(direction, x.normal))),
                    .samplerSeed = sampler.seed,
                    .media = x.media},
                   1, gather, [&](const Shading& shading) {
                       if (shading.visible) {
                           L += lookUp(world, maps, *shading.visible) / static_cast<double>(rays);
                       }
                   });
    }
    return L;
}

// One shadow ray to every light whose visibility the shadow photons leave open; of many lights, to one that is picked.
glm::dvec3 directLight(const World& world, const PhotonMaps& maps, const VisiblePoint& x, std::uint32_t pass) {
    if (x.depth + 1 > world.render.maxDepth) {
        return glm::dvec3(0);
    }
    const auto lights = static_cast<std::uint32_t>(world.lights.size());
    if (lights > kMostLightsAsked) {
        const std::optional<LightSample> sample = sampleLight(world, x, pass, std::nullopt);
        return sample ? arriving(world, *sample) : glm::dvec3(0);
    }
    const Visibility known = maps.shadow
                                 ? classifyVisibility(*maps.shadow, x, lights, world.render.photonMap.shadowPhotons,
                                                      world.causticRadius, world.surfaceError)
                                 : Visibility{};
    glm::dvec3 L(0);
    for (std::uint32_t light = 0; light < lights; ++light) {
        const std::optional<LightSample> sample = sampleLight(world, x, pass, light);
        const bool isLit = light < 32 && (known.lit >> light & 1U) != 0;
        const bool isShadowed = light < 32 && (known.shadowed >> light & 1U) != 0;
        if (sample && !isShadowed) {
            L += isLit ? sample->contribution : arriving(world, *sample);
        }
    }
    return L;
}

LightComponents lightAt(const World& world, const PhotonMaps& maps, const VisiblePoint& x, std::uint32_t pass) {
    LightComponents light;
    light.direct = directLight(world, maps, x, pass);
    if (maps.caustic) {
        light.caustic = estimateRadiance(*maps.caustic, x, causticOptions(world, maps.causticRadius)).radiance;
    }
    light.indirect =
        world.render.photonMap.gatherRays > 0
            ? finalGather(world, maps, x, pass)
            : estimateRadiance(maps.global, x, globalOptions(world, maps.globalRadius, kindBit(PhotonKind::Indirect)))
                  .radiance;
    return light;
}

} // namespace

RadianceEstimateOptions globalOptions(const World& world, double radius, std::uint32_t kinds) {
    const PhotonMapSettings& settings = world.render.photonMap;
    return {.nearest = settings.nearest,
            .radius = radius,
            .kinds = kinds,
            .maxDepth = world.render.maxDepth,
            .filter = settings.filter,
            .coneConstant = settings.coneConstant,
            .maxChange = 0,
            .surfaceError = world.surfaceError,
            .eye = world.camera.position,
            .footprint = 0}; // diffuse surfaces do not focus
}

RadianceEstimateOptions causticOptions(const World& world, double radius) {
    const PhotonMapSettings& settings = world.render.photonMap;
    return {.nearest = settings.causticNearest,
            .radius = radius,
            .kinds = kindBit(PhotonKind::Caustic),
            .maxDepth = world.render.maxDepth,
            .filter = settings.causticFilter,
            .coneConstant = settings.coneConstant,
            .maxChange = settings.differentialChecking ? 0.5 : 0,
            .surfaceError = world.surfaceError,
            .eye = world.camera.position,
            .footprint = world.pixelFootprint};
}

LightComponents& LightComponents::operator+=(const LightComponents& other) {
    emitted += other.emitted;
    direct += other.direct;
    caustic += other.caustic;
    indirect += other.indirect;
    return *this;
}

PhotonMaps buildPhotonMaps(const World& world) {
    const PhotonMapSettings& settings = world.render.photonMap;
    PhotonMaps maps{.global = traceGlobalMap(world),
                    .caustic = traceCausticMap(world),
                    .shadow = {},
                    .irradiance = {},
                    .globalRadius = world.globalRadius,
                    .causticRadius = world.causticRadius};
    if (world.render.radius == 0) {
        maps.globalRadius = largestEstimate(world, maps.global, settings.nearest, world.globalRadius, 0);
    }
    if (settings.causticRadius == 0 && maps.caustic) {
        maps.causticRadius =
            largestEstimate(world, *maps.caustic, settings.causticNearest, world.causticRadius, world.pixelFootprint);
    }
    if (settings.shadowPhotons > 0) {
        maps.shadow = PhotonMap(castShadowPhotons(world, 0));
    }
    if (settings.gatherRays > 0 && settings.precomputedIrradiance) {
        maps.irradiance = computeIrradiance(world, maps.global, maps.globalRadius);
    }
    return maps;
}

LightComponents photonMapRadiance(const World& world, const PhotonMaps& maps, std::uint32_t pixel, std::uint32_t pass) {
    LightComponents light;
    followPath(world, generateCameraRay(world, pixel, pass), beginCameraPath(world, pixel, pass), 1, pass,
               [&](const Shading& shading) {
                   light.emitted += shading.emitted;
                   if (shading.rough) {
                       light.direct += directRoughLight(world, *shading.rough, pass);
                   }
                   if (shading.visible) {
                       light += lightAt(world, maps, *shading.visible, pass);
                   }
               });
    return light;
}

} // namespace hyalite::reference
