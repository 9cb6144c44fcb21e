// One path per sample. At each diffuse or rough surface one shadow ray samples one light, and the path may also hit
// that light by itself: the two estimates are weighted by their sampling densities [Veach95].
#include "reference/integrators/path.h"

#include "reference/film/film.h"
#include "reference/integrators/shading.h"
#include "reference/lib/sampling.h"
#include "reference/lights/receiver.h"

#include <algorithm>
#include <numbers>

namespace hyalite::reference {

namespace {

// Light from one shadow ray, which makes the path one segment longer.
glm::dvec3 directLight(const World& world, const VisiblePoint& x, std::uint32_t pass) {
    if (x.depth + 1 > world.render.maxDepth) {
        return glm::dvec3(0);
    }
    const std::optional<LightSample> sample = sampleLight(world, x, pass, std::nullopt);
    if (!sample) {
        return glm::dvec3(0);
    }
    const double weight = sample->pdfW > 0 ? powerHeuristic(sample->pdfW, sample->cosine / std::numbers::pi) : 1;
    return weight * arriving(world, *sample);
}

} // namespace

// Cosine-weighted: f cos / pdfW = pi f. Russian roulette: the survival probability follows the throughput [Arvo90].
std::optional<NextRay> bouncePath(const World& world, const VisiblePoint& x, const CameraPath& path, std::uint32_t pass,
                                  double shift) {
    const shared::Sampler sampler = shared::pathSampler(x.samplerSeed, pass);
    const std::uint32_t vertex = x.depth - 1;
    const glm::dvec3 direction =
        cosineHemisphere(sampleUnitSquare(sampler, shared::pathBounce(vertex), shift), x.normal);
    if (glm::dot(direction, x.geometricNormal) <= 0) { // an interpolated normal may tilt the direction into the surface
        return std::nullopt;
    }
    const double cosine = glm::dot(direction, x.normal);
    const Receiver receiver = receiverAt(x);
    const glm::dvec3 beta = (std::numbers::pi * receiver.incident(cosine)) * receiver.f;
    const double survival = std::min(1.0, std::max({beta.x, beta.y, beta.z}));
    if (x.depth >= world.render.maxDepth ||
        sampleUnitSquare(sampler, shared::pathRoulette(vertex), shift).x >= survival) {
        return std::nullopt;
    }
    return NextRay{.ray = {.origin = x.shadowOrigin, .direction = direction},
                   .path = {.beta = beta / survival,
                            .samplerSeed = path.samplerSeed,
                            .media = path.media,
                            .pdfW = cosine / std::numbers::pi}};
}

glm::dvec3 pathRadiance(const World& world, std::uint32_t pixel, std::uint32_t pass) {
    NextRay step{.ray = generateCameraRay(world, pixel, pass), .path = beginCameraPath(world, pixel, pass)};
    glm::dvec3 L(0);
    for (std::uint32_t depth = 1; depth <= world.render.maxDepth; ++depth) {
        const std::optional<Hit> hit = traceClosest(world, step.ray);
        const Shading shading =
            hit ? shadeSurface(world, step.ray, *hit, step.path, depth, pass) : shadeMiss(world, step.ray, step.path);
        L += shading.emitted;
        if (shading.rough) {
            L += directRoughLight(world, *shading.rough, pass);
        }
        std::optional<NextRay> next = shading.next[0];
        if (shading.visible) {
            L += directLight(world, *shading.visible, pass);
            next = bouncePath(world, *shading.visible, step.path, pass);
        }
        if (!next) {
            break;
        }
        step = *next;
    }
    return L;
}

LayeredImage renderPath(const World& world, const RenderOptions& options) {
    Film film(world.camera.width, world.camera.height,
              [&](std::uint32_t pixel, std::uint32_t pass) { return seeksLight(world, pixel, pass); });
    for (std::uint32_t pass = 0; pass < world.render.passes; ++pass) {
        film.addPass([&](std::uint32_t pixel) { return pathRadiance(world, pixel, pass); });
        if (options.afterPass && !options.afterPass(pass + 1, film.error())) {
            break;
        }
    }
    return film.mean();
}

} // namespace hyalite::reference
