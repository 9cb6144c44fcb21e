// sample_lights and emit_photons against their twins.
#include "kernel/kernel_support.h"
#include "reference/photons.h"

#include <bit>

namespace hyalite::testing {

namespace {

// The quad light, a second one, a disk stretched to an ellipse, a sphere, and two point lights.
Scene everyLight() {
    Scene scene = reference::test::cornellBox();
    scene.lights = {{{0.2, 0.5, 0.1}, {1, 2, 3}}, {{-0.7, -0.1, 0.3}, {4, 1, 0.5}}};
    reference::test::addObject(scene, Quad{{-0.99, -0.2, -0.3}, {0, 0.4, 0}, {0, 0.1, 0.6}}, std::nullopt, {3, 2, 9});
    reference::test::addObject(scene, Disk{{0.5, 0.9, -0.5}, {0.2, 0, 0}, {0, 0.05, 0.3}}, std::nullopt, {5, 5, 2});
    reference::test::addObject(scene, Sphere{{-0.5, 0.5, 0.5}, 0.15}, std::nullopt, {2, 6, 3});
    return scene;
}

} // namespace

TEST_CASE("light sampling sends the reference's contribution along the reference's ray") {
    BothSides both(everyLight());
    reference::test::Random random;
    const std::uint32_t count = 20000;
    std::vector<shared::VisiblePoint> points(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        points[i] = {
            random.inCube(0.9),       i % 13, random.direction(), shared::hash(i), vec3(0.3, 0.2, 0.1), i, 0, 0,
            static_cast<float>(i % 2)};
    }
    const auto devicePoints = both.upload(points);
    const auto rays = both.room<shared::Ray>(count);
    const auto contributions = both.room<vec3>(count);
    const std::uint32_t pass = 9;
    for (const std::uint32_t light : {shared::kNone, 0U, 3U, 4U, 5U}) {
        both.run("sample_lights",
                 shared::SampleLightsArguments{devicePoints, both.deviceScene.lights, rays, contributions, count, 6,
                                               light, pass, both.scene.render.maxDepth},
                 count);
        // The strongest contribution at one metre, both cosines 1: f times intensity or radiance times area, over pmf
        double full = 0;
        for (const reference::Light& l : both.world.lights) {
            const double strength = glm::length(l.power) / (light == shared::kNone ? l.pmf : 1.0) / std::numbers::pi;
            full = std::max(full, glm::length(dvec3(0.3, 0.2, 0.1)) * strength);
        }
        std::size_t lit = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const shared::VisiblePoint& p = points[i];
            const bool shortEnough = p.depth > 0 && p.depth + 1 <= both.scene.render.maxDepth;
            const reference::VisiblePoint x{p.position, p.position, dvec3(p.normal), dvec3(p.normal),
                                            dvec3(p.f), p.depth,    p.samplerSeed,   p.coat != 0};
            const auto one = light == shared::kNone ? std::nullopt : std::optional<std::uint32_t>(light);
            const auto sample = shortEnough ? reference::sampleLight(both.world, x, pass, one) : std::nullopt;
            const reference::LightSample expected = sample.value_or(reference::LightSample{});
            const shared::Ray& ray = rays.host()[i];
            const vec3 contribution = contributions.host()[i];
            if (!sample || ray.tMax == 0) { // on the light's or the surface's horizon either side may say no
                CHECK(glm::length(expected.contribution) < 1e-4);
                CHECK((ray.tMax == 0 || glm::length(contribution) < 1e-4));
                continue;
            }
            ++lit;
            // Cosines and distances are right to 2e-6, compared with what both cosines at 1 would let through
            const double d = glm::length(expected.to - expected.from);
            CHECK(distance(contribution, expected.contribution) <= 2e-6 * full / (d * d) * (1 + 1 / d));
            CHECK(distance(ray.origin + ray.tMax * ray.direction, expected.to) < 2e-6);
        }
        CHECK(lit > count / 10);
    }
}

TEST_CASE("photons leave the lights as in the reference, in proportion to power") {
    Scene scene = everyLight();
    scene.render.photons = 20000;
    BothSides both(scene);
    const std::uint32_t count = scene.render.photons;
    const auto rays = both.room<shared::Ray>(count);
    const auto paths = both.room<shared::PhotonPath>(count);
    const auto pass = reference::progressivePass(both.world, 2);
    both.run("emit_photons",
             shared::EmitPhotonsArguments{both.deviceScene.lights, rays, paths, count, 6, pass.sequence}, count);
    dvec3 flux(0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const reference::Emission expected = reference::emitPhoton(both.world, i, pass);
        CHECK(distance(rays.host()[i].origin, expected.ray.origin) < 2e-6);
        CHECK(distance(rays.host()[i].direction, expected.ray.direction) < 1e-5);
        CHECK(distance(paths.host()[i].power, expected.power) < 1e-5 * glm::length(expected.power));
        CHECK(paths.host()[i].photon == i);
        flux += dvec3(paths.host()[i].power);
    }
    // Every light's flux: 4 pi I for points, pi A L for areas. The choice of lights is stratified over the photons:
    // the share of each is right to about one photon in 20 000.
    const double pi = std::numbers::pi;
    const double area = glm::length(glm::cross(dvec3(0, 0.4, 0), dvec3(0, 0.1, 0.6)));
    const double diskArea = pi * glm::length(glm::cross(dvec3(0.2, 0, 0), dvec3(0, 0.05, 0.3)));
    const double sphereArea = 4 * pi * 0.15 * 0.15;
    const dvec3 total = 4 * pi * dvec3(5, 3, 3.5) + pi * 0.25 * dvec3(18.4, 15.6, 8) + pi * area * dvec3(3, 2, 9) +
                        pi * diskArea * dvec3(5, 5, 2) + pi * sphereArea * dvec3(2, 6, 3);
    CHECK(glm::length(flux - total) < 1e-3 * glm::length(total));
}

} // namespace hyalite::testing
