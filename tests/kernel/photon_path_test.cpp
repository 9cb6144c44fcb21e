// scatter_photon against its twin, bounce after bounce.
#include "kernel/kernel_support.h"
#include "reference/photons.h"

#include <catch2/generators/catch_generators.hpp>

namespace hyalite::testing {

namespace {

// Half a step of 2/4095 in x and y is up to one in z, 6e-4 in all, on a vector of length 1/sqrt(3) at least: the
// octahedral encoding of 12 bits is right to 1.04e-3.
constexpr double kNormalError = 1.04e-3;

dvec3 unpackNormal(std::uint32_t bits) {
    const auto coordinate = [](std::uint32_t v) { return (v & 0xfffU) / 4095.0 * 2 - 1; };
    dvec3 v(coordinate(bits), coordinate(bits >> 12), 0);
    v.z = 1 - std::abs(v.x) - std::abs(v.y);
    if (v.z < 0) {
        const dvec3 folded = v;
        v.x = (1 - std::abs(folded.y)) * (folded.x < 0 ? -1 : 1);
        v.y = (1 - std::abs(folded.x)) * (folded.y < 0 ? -1 : 1);
    }
    return glm::normalize(v);
}

} // namespace

TEST_CASE("photons are stored, scattered and absorbed as in the reference at every depth") {
    const bool meshes = GENERATE(false, true);
    Scene scene = meshes ? crowdedBox() : reference::test::cornellBox();
    scene.render.maxDepth = 6;
    BothSides both(scene);
    reference::test::Random random;
    const std::uint32_t count = 10000;
    const std::uint32_t pass = 5;
    std::vector<shared::Ray> rays;
    std::vector<shared::PhotonPath> paths;
    for (std::uint32_t i = 0; i < count; ++i) {
        const dvec3 origin = random.inCube(0.99);
        rays.push_back(toDevice({.origin = origin, .direction = random.direction()}));
        paths.push_back({vec3(3, 2, 1), i});
    }
    const auto deviceRays = both.upload(rays);
    const auto devicePaths = both.upload(paths);
    const auto hits = both.room<shared::Hit>(count);
    const auto photons = both.room<shared::Photon>(count + 7);
    const auto nextRays = both.room<shared::Ray>(count);
    const auto nextPaths = both.room<shared::PhotonPath>(count);
    const auto alive = both.room<shared::uint>(count);
    both.run("trace_closest", shared::TraceClosestArguments{deviceRays, hits, count, both.deviceScene.rootNode}, count);

    for (const std::uint32_t depth : {1U, 2U, 4U, 5U}) {
        const auto& d = both.deviceScene;
        both.run("scatter_photon",
                 shared::ScatterPhotonArguments{deviceRays, hits, devicePaths, d.materials, d.normals, d.instances,
                                                photons, nextRays, nextPaths, alive, count, 7, depth,
                                                scene.render.maxDepth, scene.render.seed, pass},
                 count);
        std::size_t stored = 0;
        std::size_t coins = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const reference::Ray ray = toReference(rays[i]);
            const auto hit = reference::traceClosest(both.world, ray);
            if (!hit || hit->object != both.sceneObject(hits.host()[i].object)) {
                continue;
            }
            const auto expected =
                reference::scatterPhoton(both.world, ray, *hit, {dvec3(paths[i].power), i}, depth, pass);
            const shared::Photon& photon = photons.host()[7 + i];
            REQUIRE((photon.surface != shared::kNone) == expected.stored.has_value());
            if (expected.stored) {
                ++stored;
                CHECK(distance(photon.position, expected.stored->position) < 2e-5);
                CHECK(distance(photon.power, expected.stored->power) < 1e-6);
                CHECK(photon.surface >> 24U == depth);
                CHECK(glm::length(unpackNormal(photon.surface) - expected.stored->normal) < kNormalError);
            }
            const bool goesOn = alive.host()[i] != 0;
            if (goesOn != expected.next.has_value() ||
                (goesOn && glm::dot(dvec3(nextRays.host()[i].direction), expected.next->direction) < 0.99)) {
                ++coins; // the random number and the threshold agree to rounding
                continue;
            }
            if (goesOn) {
                const dvec3 normal = reference::evaluateSurface(both.world, ray, *hit).normal;
                const double condition = conditioning(ray.direction, expected.next->direction, normal);
                CHECK(distance(nextRays.host()[i].direction, expected.next->direction) * condition < 1e-5);
                CHECK(distance(nextRays.host()[i].origin, expected.next->origin) < 2e-5);
                CHECK(distance(nextPaths.host()[i].power, expected.path.power) < 1e-5);
                CHECK(nextPaths.host()[i].photon == i);
            }
        }
        CHECK(coins <= 2);
        CHECK((stored > count / 4) == (depth >= 2));
    }
}

} // namespace hyalite::testing
