// Camera rays, distributed uniformly over a pixel by the sampler.
#include "reference/camera/camera.h"

#include "reference/lib/sampling.h"
#include "reference/world.h"
#include "scene/model/render_seed.h"

#include <cmath>

namespace hyalite::reference {

CameraFrame makeCameraFrame(const Camera& camera, const std::string& sceneFile) {
    const glm::dvec3 view = camera.lookAt - camera.position;
    const glm::dvec3 side = glm::cross(view, camera.up);
    if (!(glm::length(side) > 0)) {
        throw Error(ExitCode::BadInput, SourceLocation{.file = sceneFile},
                    "the camera's up is parallel to its view direction, or its position is the point it looks at",
                    "choose another camera.up or camera.look_at");
    }
    const glm::dvec3 forward = glm::normalize(view);
    const glm::dvec3 right = glm::normalize(side);
    const double tangent = std::tan(glm::radians(camera.fov) / 2);
    const double aspect = static_cast<double>(camera.resolution.x) / static_cast<double>(camera.resolution.y);
    return {.position = camera.position,
            .forward = forward,
            .right = right * (tangent * aspect),
            .up = glm::cross(right, forward) * tangent,
            .width = camera.resolution.x,
            .height = camera.resolution.y,
            .lensRadius = camera.aperture / 2,
            .focusDistance = camera.focusDistance > 0 ? camera.focusDistance : glm::length(view)};
}

Ray generateCameraRay(const CameraFrame& camera, const RenderSettings& render, std::uint32_t pixel,
                      std::uint32_t pass) {
    const shared::Sampler sampler = shared::cameraSampler(renderSeed(render), pass, pixel);
    const glm::dvec2 uv = sampleUnitSquare(sampler, shared::kCameraPixel);
    const std::uint32_t x = pixel % camera.width;
    const std::uint32_t y = pixel / camera.width;
    const double sx = 2 * (x + uv.x) / camera.width - 1;
    const double sy = 1 - 2 * (y + uv.y) / camera.height;
    const glm::dvec3 through = camera.forward + sx * camera.right + sy * camera.up;
    if (camera.lensRadius == 0) {
        return {.origin = camera.position, .direction = glm::normalize(through)};
    }
    // All lens rays of an image point meet where its central ray crosses the plane of focus.
    const glm::dvec3 inFocus = camera.position + camera.focusDistance * through;
    const glm::dvec2 disc = concentricDisc(sampleUnitSquare(sampler, shared::kCameraLens));
    const glm::dvec3 origin = camera.position + camera.lensRadius * disc.x * glm::normalize(camera.right) +
                              camera.lensRadius * disc.y * glm::normalize(camera.up);
    return {.origin = origin, .direction = glm::normalize(inFocus - origin)};
}

Ray generateCameraRay(const World& world, std::uint32_t pixel, std::uint32_t pass) {
    return generateCameraRay(world.camera, world.render, pixel, pass);
}

} // namespace hyalite::reference
