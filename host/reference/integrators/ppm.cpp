// Each pass is a complete picture with its own photons and a smaller search radius than the one before; their mean
// converges, since bias and variance both vanish [Knaus11].
#include "reference/integrators/ppm.h"

#include "geometry/search_radius.h"
#include "reference/film/film.h"
#include "reference/integrators/shading.h"
#include "scene/model/render_seed.h"

#include <algorithm>
#include <cmath>

namespace hyalite::reference {

namespace {

// One shadow ray to one light, picked by the pmf: covers the paths that photons of depth 1 would cover.
glm::dvec3 directLight(const World& world, const VisiblePoint& x, std::uint32_t pass) {
    if (x.depth + 1 > world.render.maxDepth) {
        return glm::dvec3(0);
    }
    const std::optional<LightSample> sample = sampleLight(world, x, pass, std::nullopt);
    return sample ? arriving(world, *sample) : glm::dvec3(0);
}

bool hasCausticMap(const World& world) {
    return world.render.photonMap.causticPhotons > 0 && !world.targets.empty();
}

PhotonPass globalPass(const World& world, std::uint32_t pass) {
    PhotonPass global = progressivePass(world, pass);
    if (hasCausticMap(world)) {
        global.kinds = kindBit(PhotonKind::Indirect);
    }
    return global;
}

PhotonPass causticPass(const World& world, std::uint32_t pass) {
    return {.sequence = shared::photonSequence(renderSeed(world.render), shared::kCausticPhotons, pass),
            .count = world.render.photonMap.causticPhotons,
            .kinds = kindBit(PhotonKind::Caustic),
            .aimed = world.render.photonMap.projectionMap};
}

double radiusByPilot(const World& world, PhotonPass pilot, double wanted) {
    const std::uint32_t emitted = pilot.count;
    pilot.count = std::min(emitted, kPilotPhotons);
    const auto trace = [&] {
        std::vector<glm::dvec3> positions;
        for (const Photon& photon : tracePhotons(world, pilot)) {
            positions.push_back(photon.position);
        }
        return positions;
    };
    std::vector<glm::dvec3> positions = trace();
    if (positions.size() < kFewPhotons && pilot.count < emitted) {
        pilot.count = emitted;
        positions = trace();
    }
    return searchRadiusFor(wanted, positions, pilot.count, emitted,
                           {.sceneRadius = world.sceneRadius,
                            .eye = world.camera.position,
                            .footprint = pilot.kinds == kindBit(PhotonKind::Caustic) ? world.pixelFootprint : 0});
}

glm::dvec3 gather(const ProgressiveMap& map, const VisiblePoint& x, const World& world) {
    return gatherRadiance(map.photons, x, map.radius, world.render.maxDepth, world.surfaceError);
}

glm::dvec3 tracePath(const World& world, const ProgressiveMaps& maps, const Ray& ray, const CameraPath& path,
                     std::uint32_t depth, std::uint32_t pass) {
    const std::optional<Hit> hit = traceClosest(world, ray);
    const Shading shading = hit ? shadeSurface(world, ray, *hit, path, depth, pass) : shadeMiss(world, ray, path);
    glm::dvec3 L = shading.emitted;
    if (shading.visible) {
        L += directLight(world, *shading.visible, pass);
        L += gather(maps.global, *shading.visible, world);
        if (maps.caustic) {
            L += gather(*maps.caustic, *shading.visible, world);
        }
    }
    if (shading.rough) {
        L += directRoughLight(world, *shading.rough, pass);
    }
    for (const std::optional<NextRay>& next : shading.next) {
        if (next) {
            L += tracePath(world, maps, next->ray, next->path, depth + 1, pass);
        }
    }
    return L;
}

} // namespace

SearchRadii firstRadii(const World& world) {
    const double globalRadius = world.render.radius;
    const double causticRadius = world.render.photonMap.causticRadius;
    SearchRadii radii;
    radii.global = globalRadius > 0 ? globalRadius : radiusByPilot(world, globalPass(world, 0), kPhotonsPerSearch);
    if (hasCausticMap(world)) {
        radii.caustic =
            causticRadius > 0 ? causticRadius : radiusByPilot(world, causticPass(world, 0), kCausticPhotonsPerSearch);
    }
    return radii;
}

ProgressiveMaps traceProgressive(const World& world, const SearchRadii& radii, std::uint32_t pass) {
    ProgressiveMaps maps{.global = {PhotonMap(tracePhotons(world, globalPass(world, pass))), radii.global},
                         .caustic = std::nullopt};
    if (hasCausticMap(world)) {
        maps.caustic = {PhotonMap(tracePhotons(world, causticPass(world, pass))), radii.caustic};
    }
    return maps;
}

glm::dvec3 ppmRadiance(const World& world, const ProgressiveMaps& maps, std::uint32_t pixel, std::uint32_t pass) {
    return tracePath(world, maps, generateCameraRay(world, pixel, pass), beginCameraPath(world, pixel, pass), 1, pass);
}

double nextRadius2(double radius2, std::uint32_t pass, double alpha) {
    // r^2_{i+1} = r^2_i (i + alpha) / (i + 1) with passes counted from 1, as [Knaus11] does: i = pass + 1.
    const double i = pass + 1.0;
    return radius2 * (i + alpha) / (i + 1);
}

LayeredImage renderPpm(const World& world, const RenderOptions& options) {
    Film film(world.camera.width, world.camera.height,
              [&](std::uint32_t pixel, std::uint32_t pass) { return seeksLight(world, pixel, pass); });
    SearchRadii radii = firstRadii(world);
    for (std::uint32_t pass = 0; pass < world.render.passes; ++pass) {
        const ProgressiveMaps maps = traceProgressive(world, radii, pass);
        film.addPass([&](std::uint32_t pixel) { return ppmRadiance(world, maps, pixel, pass); });
        if (options.afterPass && !options.afterPass(pass + 1, film.error())) {
            break;
        }
        for (double* radius : {&radii.global, &radii.caustic}) {
            *radius = std::sqrt(nextRadius2(*radius * *radius, pass, world.render.alpha));
        }
    }
    return film.mean();
}

} // namespace hyalite::reference
