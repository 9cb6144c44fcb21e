// The pick of a light for a receiver, against its twin: light samples divide by its probability.
#include "kernel/every_light.h"
#include "reference/lights/light_choice.h"
#include "unit/gpu/temporary_shaders.h"

#include <catch2/generators/catch_generators.hpp>

namespace hyalite::testing {

namespace {

struct PickLightsArguments {
    shared::LightArray lights;
    shared::ColorArray receivers;
    shared::ColorArray picks; // out: the light, its probability, and that asked again
    shared::FloatArray sums;  // out: of the probabilities of all lights
    std::uint32_t lightCount;
    std::uint32_t count;
};

constexpr const char* kKernel = R"(#version 460
#include "shared/kernel_arguments.h"
#include "lights/light.glsl"
#include "lib/thread.glsl"
struct Arguments {
    LightArray lights;
    ColorArray receivers;
    ColorArray picks;
    FloatArray sums;
    uint lightCount;
    uint count;
};
layout(push_constant, scalar) uniform Push { Arguments args; };
void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    vec3 x = args.receivers.at[i];
    LightPick pick = pickLightAt(args.lights, x, sampleUnit(photonSampler(5u, i), 0u));
    args.picks.at[i] = vec3(float(pick.light), pick.pmf, pickProbability(args.lights, pick.light, x));
    float sum = 0.0;
    for (uint light = 0u; light < args.lightCount; ++light) {
        sum += pickProbability(args.lights, light, x);
    }
    args.sums.at[i] = sum;
}
)";

// Every light, and many more of very different strength.
Scene crowdOfLights() {
    Scene scene = everyLight();
    reference::test::Random random;
    for (int i = 0; i < 100; ++i) {
        scene.lights.push_back({random.inCube(1), dvec3(std::pow(10, random.between(-4, 4)))});
    }
    return scene;
}

// One that is near and two that are far.
Scene fewLights() {
    Scene scene = everyLight();
    scene.environment.reset();
    scene.spots.clear();
    scene.lights.resize(1);
    std::erase_if(scene.objects, [](const Object& object) { return object.emission != dvec3(0); });
    REQUIRE(scene.directionals.size() >= 2);
    scene.directionals.resize(2);
    return scene;
}

// Three quads, which shine to one side.
Scene fewEmitters() {
    Scene scene = fewLights();
    scene.directionals.clear();
    scene.lights.clear();
    for (int i = 0; i < 3; ++i) {
        reference::test::addObject(scene, Quad{{i - 1.0, 1.2, 0.1 * i}, {0.5, 0, 0}, {0, 0.2, 0.5}}, std::nullopt,
                                   dvec3(1 + 3 * i));
    }
    return scene;
}

} // namespace

TEST_CASE("the device picks a receiver's light as the reference does, and its probabilities add up to 1") {
    const auto scene = GENERATE(everyLight(), crowdOfLights(), fewLights(), fewEmitters());
    BothSides both(scene);
    const TemporaryShaders folder;
    folder.write("kernels/pick_lights.comp", kKernel);
    const gpu::Kernel kernel(both.device.context, both.device.tables, gpu::ShaderCompiler(folder.shaders()),
                             "pick_lights", both.deviceScene.specialization);
    const std::uint32_t count = 4000;
    reference::test::Random random;
    std::vector<vec3> receivers(count);
    for (vec3& x : receivers) {
        x = vec3(random.inCube(1.5));
    }
    const auto deviceReceivers = both.upload(receivers);
    const auto picks = both.room<vec3>(count);
    const auto sums = both.room<float>(count);
    both.device.commands.run(
        kernel,
        PickLightsArguments{both.deviceScene.lights, deviceReceivers, picks, sums, both.deviceScene.lightCount, count},
        count);
    both.device.commands.finish();
    std::size_t coins = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const vec3 found = picks.host()[i];
        const auto light = static_cast<std::uint32_t>(found.x);
        const dvec3 x(receivers[i]);
        // Ten levels of quotients of some ten roundings each; the tip of a faded cone loses three digits
        const double expected = reference::pickProbability(both.world, light, x);
        REQUIRE(std::abs(double{found.y} / expected - 1) < 1e-3);
        REQUIRE(std::abs(double{found.z} / expected - 1) < 1e-3);
        REQUIRE(std::abs(double{sums.host()[i]} - 1) < 1e-4);
        const reference::LightPick twin =
            reference::pickLightAt(both.world, x, reference::sampleUnitSquare(shared::photonSampler(5, i), 0));
        coins += twin.light == light ? 0 : 1;
    }
    CHECK(coins <= 3); // a number within rounding of a boundary
}

} // namespace hyalite::testing
