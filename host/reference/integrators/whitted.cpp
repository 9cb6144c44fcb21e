// The tree of rays: every mirror has one child, every glass boundary two [Whitted80].
#include "reference/integrators/whitted.h"

#include "reference/film/film.h"
#include "reference/integrators/shading.h"

namespace hyalite::reference {

namespace {

glm::dvec3 traceTree(const World& world, const Ray& ray, const CameraPath& path, std::uint32_t depth,
                     std::uint32_t pass) {
    const std::optional<Hit> hit = traceClosest(world, ray);
    const Shading shading = hit ? shadeSurface(world, ray, *hit, path, depth, pass) : shadeMiss(world, ray, path);
    glm::dvec3 L = shading.emitted;
    const auto add = [&](const std::optional<LightSample>& sample) {
        if (sample) {
            L += arriving(world, *sample);
        }
    };
    for (std::uint32_t light = 0; light < world.lights.size(); ++light) {
        if (shading.visible) {
            add(sampleLight(world, *shading.visible, pass, light));
        }
        if (shading.rough) {
            add(sampleRoughLight(world, *shading.rough, pass, light));
        }
    }
    for (const std::optional<NextRay>& next : shading.next) {
        if (next) {
            L += traceTree(world, next->ray, next->path, depth + 1, pass);
        }
    }
    return L;
}

} // namespace

glm::dvec3 whittedRadiance(const World& world, std::uint32_t pixel, std::uint32_t pass) {
    return traceTree(world, generateCameraRay(world, pixel, pass), beginCameraPath(world, pixel, pass), 1, pass);
}

LayeredImage renderWhitted(const World& world, const RenderOptions& options) {
    // Every light is asked at every surface: a black pixel is not for want of luck
    Film film(world.camera.width, world.camera.height, [](std::uint32_t, std::uint32_t) { return false; });
    for (std::uint32_t pass = 0; pass < world.render.passes; ++pass) {
        film.addPass([&](std::uint32_t pixel) { return whittedRadiance(world, pixel, pass); });
        if (options.afterPass && !options.afterPass(pass + 1, film.error())) {
            break;
        }
    }
    return film.mean();
}

} // namespace hyalite::reference
