// One path a sample. At each diffuse surface a shadow ray to one light brings its light; so light that the path then
// meets by itself counts only where no shadow ray could have brought it: after the camera, mirrors and glass.
#include "reference/path.h"

#include "reference/film.h"
#include "reference/sampling.h"
#include "reference/shading.h"

#include <algorithm>
#include <numbers>

namespace hyalite::reference {

namespace {

// Light that one shadow ray brings, by a path of one segment more.
glm::dvec3 directLight(const World& world, const VisiblePoint& x, std::uint32_t pass) {
    if (x.depth + 1 > world.render.maxDepth) {
        return glm::dvec3(0);
    }
    const std::optional<LightSample> sample = sampleLight(world, x, pass, std::nullopt);
    return sample && traceShadow(world, sample->from, sample->to) ? sample->contribution : glm::dvec3(0);
}

// The way on from a diffuse surface, by the cosine: f cos / pdfW = pi f. Roulette ends paths in proportion to what they
// still carry [Arvo90]. None: the path ends.
std::optional<NextRay> bounce(const World& world, const VisiblePoint& x, const CameraPath& path, std::uint32_t pass) {
    const shared::Sampler sampler{.seed = x.samplerSeed, .index = pass};
    const std::uint32_t vertex = x.depth - 1;
    const glm::dvec3 beta = std::numbers::pi * x.f;
    const double survival = std::min(1.0, std::max({beta.x, beta.y, beta.z}));
    if (x.depth >= world.render.maxDepth || sampleUnitSquare(sampler, shared::pathRoulette(vertex)).x >= survival) {
        return std::nullopt;
    }
    const glm::dvec3 direction = cosineHemisphere(sampleUnitSquare(sampler, shared::pathBounce(vertex)), x.normal);
    if (glm::dot(direction, x.geometricNormal) <= 0) { // a smoothed normal leans over: this way leads into the surface
        return std::nullopt;
    }
    return NextRay{.ray = {.origin = x.shadowOrigin, .direction = direction},
                   .path = {.beta = beta / survival, .samplerSeed = path.samplerSeed, .medium = path.medium}};
}

} // namespace

glm::dvec3 pathRadiance(const World& world, std::uint32_t pixel, std::uint32_t pass) {
    NextRay step{.ray = generateCameraRay(world, pixel, pass), .path = beginCameraPath(world, pixel, pass)};
    glm::dvec3 L(0);
    bool seesLights = true; // no shadow ray has been sent from where the present segment starts
    for (std::uint32_t depth = 1; depth <= world.render.maxDepth; ++depth) {
        const std::optional<Hit> hit = traceClosest(world, step.ray);
        if (!hit) {
            break;
        }
        const Shading shading = shadeSurface(world, step.ray, *hit, step.path, depth, pass);
        if (seesLights) {
            L += shading.emitted;
        }
        std::optional<NextRay> next = shading.next[0] ? shading.next[0] : shading.next[1];
        if (shading.visible) {
            L += directLight(world, *shading.visible, pass);
            next = bounce(world, *shading.visible, step.path, pass);
        }
        if (!next) {
            break;
        }
        seesLights = !shading.visible;
        step = *next;
    }
    return L;
}

Image renderPath(const World& world, const RenderOptions& options) {
    Film film(world.camera.width, world.camera.height);
    for (std::uint32_t pass = 0; pass < world.render.passes; ++pass) {
        film.addPass([&](std::uint32_t pixel) { return pathRadiance(world, pixel, pass); });
        if (options.afterPass && !options.afterPass(pass + 1)) {
            break;
        }
    }
    return film.mean();
}

} // namespace hyalite::reference
