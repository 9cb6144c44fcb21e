// The densities that light.glsl gives for its rays, against their twins: importance sampling and aimed photons divide
// by them.
#include "kernel/every_light.h"
#include "unit/gpu/temporary_shaders.h"

namespace hyalite::testing {

namespace {

struct LightDensitiesArguments {
    shared::LightArray lights;
    shared::ColorArray densities; // out: three a thread, see the kernel
    std::uint32_t lightCount;
    std::uint32_t count;
};

constexpr const char* kKernel = R"(#version 460
#include "shared/kernel_arguments.h"
#include "lights/light.glsl"
#include "lib/thread.glsl"
struct Arguments {
    LightArray lights;
    ColorArray densities;
    uint lightCount;
    uint count;
};
layout(push_constant, scalar) uniform Push { Arguments args; };
void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    Sampler s = photonSampler(8u, i);
    LightRecord light = args.lights.at[i % args.lightCount];
    LightRay ray = emitFrom(light, sampleUnit(s, 0u), sampleUnit(s, 1u));
    vec3 other = uniformSphere(sampleUnit(s, 2u));
    vec3 receiver = ray.origin + ray.direction;
    // The numbers that sampled the ray also sample the way back
    vec2 again = sampleUnit(s, light.type == kLightEnvironment ? 1u : 0u);
    args.densities.at[3u * i] =
        vec3(ray.pdfDirection, ray.pdfOrigin,
             lightPdf(light, receiver, -ray.direction, 1.0, ray.normal));
    args.densities.at[3u * i + 1u] =
        vec3(emissionDensity(light, ray.normal, other), originDensity(light, ray.origin + other, ray.direction),
             sampleLight(light, receiver, again).pdfW);
    args.densities.at[3u * i + 2u] = ray.power;
}
)";

} // namespace

TEST_CASE("rays from lights and to them have the reference's densities") {
    BothSides both(everyLight());
    const TemporaryShaders folder;
    folder.write("kernels/light_densities.comp", kKernel);
    const gpu::Kernel kernel(both.device.context, both.device.tables, gpu::ShaderCompiler(folder.shaders()),
                             "light_densities", both.deviceScene.specialization);
    const std::uint32_t count = 26000;
    const std::uint32_t lightCount = both.deviceScene.lightCount;
    const auto densities = both.room<vec3>(std::size_t{3} * count);
    both.device.commands.run(kernel, LightDensitiesArguments{both.deviceScene.lights, densities, lightCount, count},
                             count);
    both.device.commands.finish();
    // Equal to a few roundings and, where that counts, to how well the ray itself agrees (see light_test.cpp): the
    // falloff of a spot has a slope of 10 [1/sr] here, 1 / cos of the light's side grows without end
    const auto agree = [](double device, double expected) {
        return std::abs(device - expected) <= 2e-3 * std::abs(expected) + 1e-5;
    };
    std::size_t coins = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const shared::Sampler sampler = shared::photonSampler(8, i);
        const auto numbers = [&](std::uint32_t dimension) { return reference::sampleUnitSquare(sampler, dimension); };
        const reference::Light& light = both.world.lights[i % lightCount];
        const reference::LightRay ray = emitFrom(light, numbers(0), numbers(1));
        const dvec3 other = reference::uniformSphere(numbers(2));
        const double cosLight = ray.normal == dvec3(0) ? 1 : glm::dot(ray.normal, ray.direction);
        const vec3* found = &densities.host()[std::size_t{3} * i];
        const double toLight = cosLight * lightPdf(light, ray.origin + ray.direction, -ray.direction, 1, ray.normal);
        const bool same = agree(found[0].x, ray.pdfDirection) && agree(found[0].y, ray.pdfOrigin) &&
                          agree(found[0].z * cosLight, toLight) && agree(found[1].z * cosLight, toLight) &&
                          agree(found[1].x, emissionDensity(light, ray.normal, other)) &&
                          agree(found[1].y, originDensity(light, ray.origin + other, ray.direction)) &&
                          distance(found[2], ray.power) <= 1e-5 * glm::length(ray.power);
        coins += same ? 0 : 1;
        if (!same) {
            UNSCOPED_INFO("light " << i % lightCount << ": " << found[0].x << ' ' << found[0].y << ' ' << found[0].z
                                   << ' ' << found[1].x << ' ' << found[1].y);
        }
    }
    CHECK(coins <= 3); // another texel, triangle or side of a disc's rim
}

} // namespace hyalite::testing
