// Debug views of a scene instead of its light: each of their dispatches against its twin.
#include "parity/capture.h"
#include "render/debug/debug_view.h"
#include "render/wavefront/device.h"
#include "scene/load/load_scene.h"
#include "support/gpu_fixture.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <filesystem>

namespace hyalite::testing {

namespace {

struct Drawn {
    std::vector<parity::StageResult> stages;
    Image image;
};

// Two passes of a view, all shapes in it.
Drawn draw(render::DebugQuantity quantity) {
    Scene scene = loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes/tests/all-shapes.yaml");
    scene.camera.resolution = {64, 64};
    const Gpu& gpu = Gpu::shared();
    render::Device device(gpu.context(), gpu.compiler(), false);
    const render::DeviceScene deviceScene = render::uploadScene(gpu.context(), device.tables, scene);
    const parity::Sides sides(scene, deviceScene);
    parity::Capture capture(gpu.context(), device.tables, sides, {});
    render::Film film(device, scene.camera.resolution, render::DebugView::layers());
    render::DebugView view({.device = device, .scene = scene, .deviceScene = deviceScene, .film = film}, quantity);
    gpu::Observation observation = device.commands.observe(capture);
    for (std::uint32_t pass = 0; pass < 2; ++pass) {
        film.beginPass(pass);
        view.renderPass(pass);
        film.endPass();
    }
    observation.end();
    return {capture.finish(), film.resolve(device).picture};
}

} // namespace

TEST_CASE("normals, depths and bounces are drawn as in the reference") {
    for (const auto quantity :
         {render::DebugQuantity::Normals, render::DebugQuantity::Depth, render::DebugQuantity::Bounces}) {
        const Drawn drawn = draw(quantity);
        bool isShown =
            quantity == render::DebugQuantity::Bounces; // counted by the host, from what shade_surface leaves
        for (const parity::StageResult& stage : drawn.stages) {
            INFO(stage.name << ": " << stage.failed << " failed, " << stage.apart << " apart of " << stage.elements);
            CHECK(stage.passed());
            isShown = isShown || stage.name == "show_surface";
        }
        CHECK(isShown);
    }
}

TEST_CASE("bounces are counted from 1, and depths are those of the scene") {
    const Image bounces = draw(render::DebugQuantity::Bounces).image;
    const Image depths = draw(render::DebugQuantity::Depth).image;
    float most = 0;
    for (std::size_t i = 0; i < bounces.pixels.size(); ++i) {
        // A mean of two passes: halves are possible, and nothing else between whole numbers
        CHECK(2 * bounces.pixels[i].x == std::floor(2 * bounces.pixels[i].x));
        CHECK(depths.pixels[i].x >= 0);
        most = std::max(most, bounces.pixels[i].x);
    }
    CHECK(most >= 3); // in through glass and out of it, and then a wall
}

} // namespace hyalite::testing
