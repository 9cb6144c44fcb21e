// What lights do where the camera looks, learned on the device as in the reference.
#include "kernel/every_light.h"
#include "reference/integrators/learn_lights.h"
#include "reference/lights/light_choice.h"
#include "render/wavefront/learn_lights.h"

namespace hyalite::testing {

namespace {

// A room of 4 m with the camera and a light in it, and `behind` lights as strong on the other side of a wall.
Scene roomBesideLights(int behind) {
    Scene scene = reference::test::cornellBox();
    scene.objects.clear();
    scene.lights = {{{0, 0.8, 0}, dvec3(1)}};
    scene.camera.position = {0, 0, 1.9};
    scene.camera.lookAt = {0, 0, 0};
    reference::test::addObject(scene, Sphere{{0, 0, 0}, 2}, 0);
    reference::test::Random random;
    for (int i = 0; i < behind; ++i) {
        scene.lights.push_back({dvec3(4, 0, 0) + random.inCube(1), dvec3(1)});
    }
    return scene;
}

} // namespace

TEST_CASE("the device tries lights at the reference's places, and learns the same") {
    BothSides both(everyLight());
    const std::vector<LightUse> device = render::tryLights(both.device, both.scene, both.deviceScene);
    const std::vector<LightUse> twin = reference::tryLights(both.world);
    REQUIRE(device.size() == twin.size());
    std::uint32_t seen = 0;
    for (std::size_t i = 0; i < device.size(); ++i) {
        INFO("light " << i);
        // One path in a hundred may diverge in single precision
        const double paths = 3 + 0.02 * twin[i].tried;
        CHECK(std::abs(double(device[i].tried) - twin[i].tried) <= paths);
        CHECK(std::abs(double(device[i].seen) - twin[i].seen) <= paths);
        CHECK(std::abs(device[i].brought - twin[i].brought) <= 0.05 * twin[i].brought + 0.01);
        seen += twin[i].seen;
    }
    CHECK(seen > 500);
}

TEST_CASE("lights behind a wall get few picks and photons, and all probabilities still add up to 1") {
    BothSides both(roomBesideLights(99));
    render::learnLights(both.device, both.scene, both.deviceScene);
    render::learnLights(both.device, both.scene, both.deviceScene); // the same once more
    reference::World world = reference::prepareWorld(both.scene);
    reference::learnLights(world, photonShares(both.scene));
    const std::vector<shared::LightRecord> lights = both.deviceScene.lights.read();
    // Half of the photons go by what the lights bring, the rest by flux or evenly to all hundred
    CHECK(std::abs(double{lights[0].pmf} - (0.5 + 0.5 / 100)) < 1e-4);
    CHECK(std::abs(world.lights[0].pmf - (0.5 + 0.5 / 100)) < 1e-9);
    CHECK(lights.back().cdf == 1);
    const dvec3 place(0.5, -1.5, 0.3);
    CHECK(reference::pickProbability(world, 0, place) > 0.5);
    double sum = 0;
    for (std::uint32_t i = 0; i < world.lights.size(); ++i) {
        sum += reference::pickProbability(world, i, place);
    }
    CHECK(std::abs(sum - 1) < 1e-9);
}

} // namespace hyalite::testing
