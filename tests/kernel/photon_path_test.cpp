// scatter_photon against its twin, bounce after bounce.
#include "kernel/kernel_support.h"
#include "reference/photons/photons.h"

#include <array>

#include <catch2/generators/catch_generators.hpp>

namespace hyalite::testing {

namespace {

using reference::PhotonKind;
static_assert(shared::kPhotonDirect == static_cast<std::uint32_t>(PhotonKind::Direct));
static_assert(shared::kPhotonIndirect == static_cast<std::uint32_t>(PhotonKind::Indirect));
static_assert(shared::kPhotonCaustic == static_cast<std::uint32_t>(PhotonKind::Caustic));
static_assert(shared::kPhotonShadow == static_cast<std::uint32_t>(PhotonKind::Shadow));

// Half a step of 2/2047 in x and y is up to one in z, 1.2e-3 in all, on a vector of length 1/sqrt(3) at least: the
// octahedral encoding of 11 bits is right to 2.08e-3.
constexpr double kNormalError = 2.08e-3;

// Positions are accurate to a few 1e-7, normals on spheres of radius 0.05 to twenty times that; so are directions, and
// weights that depend on them, after dividing out their conditioning.
constexpr double kScatterError = 2e-5;

dvec3 unpackNormal(std::uint32_t bits) {
    const auto coordinate = [](std::uint32_t v) { return (v & 0x7ffU) / 2047.0 * 2 - 1; };
    dvec3 v(coordinate(bits), coordinate(bits >> 11), 0);
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
    Scene scene = GENERATE(reference::test::cornellBox(), crowdedBox(), roughBox());
    scene.render.maxDepth = 6;
    BothSides both(scene);
    reference::test::Random random;
    const std::uint32_t count = 10000;
    const std::array<std::uint32_t, 3> kinds{shared::kPhotonDirect, shared::kPhotonIndirect, shared::kPhotonCaustic};
    std::vector<shared::Ray> rays;
    std::vector<shared::PhotonPath> paths;
    for (std::uint32_t i = 0; i < count; ++i) {
        const dvec3 origin = random.inCube(0.99);
        rays.push_back(toDevice({.origin = origin, .direction = random.direction()}));
        paths.push_back({vec3(3, 2, 1), i, 4, kinds[i % 3], shared::kNone});
    }
    const auto deviceRays = both.upload(rays);
    const auto devicePaths = both.upload(paths);
    const auto hits = both.room<shared::Hit>(count);
    const auto photons = both.room<shared::Photon>(count + 7);
    const auto nextRays = both.room<shared::Ray>(count);
    const auto nextPaths = both.room<shared::PhotonPath>(count);
    const auto alive = both.room<shared::uint>(count);
    both.run("trace_closest", shared::TraceClosestArguments{deviceRays, hits, count, both.deviceScene.rootNode, 0, {}},
             count);

    const auto fates = both.room<shared::PhotonFate>(count);
    // The kinds of progressive photon mapping, of a global map and of a caustic map
    for (const auto& [depth, wanted] : {std::pair{1U, 6U}, {2U, 7U}, {3U, 4U}, {4U, 6U}, {5U, 7U}}) {
        reference::PhotonPass pass = reference::progressivePass(both.world, 5);
        pass.kinds = wanted;
        const auto& d = both.deviceScene;
        std::ranges::fill(fates.host(), shared::PhotonFate{});
        both.run(
            "scatter_photon",
            shared::ScatterPhotonArguments{deviceRays,    hits,       devicePaths, d.materials,   d.normals,
                                           d.instances,   photons,    fates,       nextRays,      nextPaths,
                                           alive,         count,      7,           depth,         scene.render.maxDepth,
                                           pass.sequence, pass.kinds, 1,           shared::kNone, {}},
            count);
        std::size_t stored = 0;
        std::size_t coins = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const reference::Ray ray = toReference(rays[i]);
            const shared::PhotonFate& fate = fates.host()[i];
            const vec3 onward = alive.host()[i] != 0 ? nextPaths.host()[i].power : vec3(0);
            CHECK(glm::length(fate.stored + fate.absorbed + fate.escaped + fate.cutOff + onward - paths[i].power) <
                  1e-6F);
            const auto hit = reference::traceClosest(both.world, ray);
            if (!hit || hit->object != both.sceneObject(hits.host()[i].object)) {
                continue;
            }
            const reference::PhotonPath path{dvec3(paths[i].power), i, 4,
                                             static_cast<reference::PhotonKind>(paths[i].kind)};
            const auto expected = reference::scatterPhoton(both.world, ray, *hit, path, depth, pass);
            const shared::Photon& photon = photons.host()[7 + i];
            REQUIRE((photon.surface != shared::kNone) == expected.stored.has_value());
            if (expected.stored) {
                ++stored;
                CHECK(distance(photon.position, expected.stored->position) < 2e-5);
                // On smoothed surfaces the flux is weighted by the ratio of two cosines, each right to kScatterError
                const reference::Surface surface = reference::evaluateSurface(both.world, ray, *hit);
                const bool isSmooth = surface.normal != surface.geometricNormal;
                const double cosine = std::abs(glm::dot(ray.direction, surface.geometricNormal));
                CHECK(distance(photon.power, expected.stored->power) <
                      (isSmooth ? kScatterError * glm::length(expected.stored->power) / cosine : 1e-6));
                CHECK(((photon.surface >> shared::kKindShift) & 3U) == paths[i].kind);
                CHECK(photon.surface >> shared::kLengthShift == (paths[i].kind == shared::kPhotonDirect ? 4U : depth));
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
                CHECK(distance(nextRays.host()[i].direction, expected.next->direction) * condition < kScatterError);
                CHECK(distance(nextRays.host()[i].origin, expected.next->origin) < 2e-5);
                CHECK(distance(nextPaths.host()[i].power, expected.path.power) * condition < kScatterError);
                CHECK(nextPaths.host()[i].photon == i);
                CHECK(nextPaths.host()[i].light == 4);
                CHECK(nextPaths.host()[i].kind == static_cast<std::uint32_t>(expected.path.kind));
            }
        }
        CHECK(coins <= 2);
        CHECK(stored > count / 8);
    }
}

} // namespace hyalite::testing
