// Each pass is a complete picture with its own photons and a smaller search radius than the one before; their mean
// converges, since bias and variance both go to zero [Knaus11].
#include "reference/ppm.h"

#include "reference/film.h"
#include "reference/shading.h"

#include <cmath>

namespace hyalite::reference {

namespace {

// One shadow ray to one light, picked by the pmf: the paths that photons of depth 1 would stand for.
glm::dvec3 directLight(const World& world, const VisiblePoint& x, std::uint32_t pass) {
    if (x.depth + 1 > world.render.maxDepth) {
        return glm::dvec3(0);
    }
    const std::optional<LightSample> sample = sampleLight(world, x, pass, std::nullopt);
    return sample && traceShadow(world, sample->from, sample->to) ? sample->contribution : glm::dvec3(0);
}

glm::dvec3 tracePath(const World& world, const PhotonMap& photons, double radius, const Ray& ray,
                     const CameraPath& path, std::uint32_t depth, std::uint32_t pass) {
    const std::optional<Hit> hit = traceClosest(world, ray);
    const Shading shading = hit ? shadeSurface(world, ray, *hit, path, depth, pass) : shadeMiss(world, ray, path);
    glm::dvec3 L = shading.emitted;
    if (shading.visible) {
        L += directLight(world, *shading.visible, pass);
        L += gatherRadiance(photons, *shading.visible, radius, world.render.maxDepth);
    }
    if (shading.rough) {
        L += directRoughLight(world, *shading.rough, pass);
    }
    for (const std::optional<NextRay>& next : shading.next) {
        if (next) {
            L += tracePath(world, photons, radius, next->ray, next->path, depth + 1, pass);
        }
    }
    return L;
}

} // namespace

glm::dvec3 ppmRadiance(const World& world, const PhotonMap& photons, double radius, std::uint32_t pixel,
                       std::uint32_t pass) {
    return tracePath(world, photons, radius, generateCameraRay(world, pixel, pass), beginCameraPath(world, pixel, pass),
                     1, pass);
}

double nextRadius2(double radius2, std::uint32_t pass, double alpha) {
    // r^2_{i+1} = r^2_i (i + alpha) / (i + 1) with passes counted from 1, as [Knaus11] does: i = pass + 1.
    const double i = pass + 1.0;
    return radius2 * (i + alpha) / (i + 1);
}

LayeredImage renderPpm(const World& world, const RenderOptions& options) {
    Film film(world.camera.width, world.camera.height);
    double radius2 = world.initialRadius * world.initialRadius;
    for (std::uint32_t pass = 0; pass < world.render.passes; ++pass) {
        const PhotonMap photons(tracePhotons(world, progressivePass(world, pass)));
        film.addPass([&](std::uint32_t pixel) { return ppmRadiance(world, photons, std::sqrt(radius2), pixel, pass); });
        if (options.afterPass && !options.afterPass(pass + 1, film.error())) {
            break;
        }
        radius2 = nextRadius2(radius2, pass, world.render.alpha);
    }
    return film.mean();
}

} // namespace hyalite::reference
