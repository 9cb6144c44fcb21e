// generate_camera_rays against its twin.
#include "kernel/kernel_support.h"
#include "reference/integrators/shading.h"
#include "scene/model/render_seed.h"

#include <catch2/generators/catch_generators.hpp>

namespace hyalite::testing {

TEST_CASE("camera rays leave through the same points of the pixel and of the lens on both sides") {
    const auto [aperture, focus] = GENERATE(std::pair{0.0, 0.0}, std::pair{0.3, 0.0}, std::pair{0.05, 1.5});
    Scene scene = reference::test::cornellBox();
    scene.camera.resolution = {37, 23}; // neither square nor a multiple of the group
    scene.camera.position = {0.3, -0.2, 3.1};
    scene.camera.lookAt = {0.1, 0.4, -0.5};
    scene.camera.aperture = aperture;
    scene.camera.focusDistance = focus;
    scene.render.seed = 77;
    BothSides both(scene);
    const std::uint32_t pixels = 37 * 23;
    const auto rays = both.room<shared::Ray>(pixels);
    const auto paths = both.room<shared::CameraPath>(pixels);
    for (const std::uint32_t pass : {0U, 1U, 1000U}) {
        both.run("generate_camera_rays",
                 shared::GenerateCameraRaysArguments{rays, paths, renderSeed(scene.render), both.deviceScene.camera,
                                                     pixels, pass},
                 pixels);
        for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
            const reference::Ray expected = reference::generateCameraRay(both.world, pixel, pass);
            const shared::Ray& ray = rays.host()[pixel];
            // A handful of roundings of numbers below 1
            REQUIRE(distance(ray.direction, expected.direction) < 1e-6);
            REQUIRE(distance(ray.origin, expected.origin) < 1e-6);
            const shared::CameraPath& path = paths.host()[pixel];
            REQUIRE(path.samplerSeed == reference::beginCameraPath(both.world, pixel, pass).samplerSeed);
            REQUIRE(path.pixel == pixel);
            REQUIRE(path.beta == vec3(1));
        }
    }
}

} // namespace hyalite::testing
