// Absorption in glass on the device against the reference: along camera paths and along photons' paths.
#include "kernel/bounce.h"
#include "kernel/visible_points.h"
#include "reference/integrators/shading.h"
#include "reference/photons/photons.h"
#include "render/upload/media_word.h"

namespace hyalite::testing {

namespace {

constexpr std::uint32_t kGlass = 4; // of the Cornell box

// Every second path runs in the glass.
std::uint32_t mediaOf(const Scene& scene, std::size_t i) {
    reference::Media media;
    if (i % 2 == 0) {
        media.enter(kGlass);
    }
    return render::mediaWord(scene, media);
}

Scene absorbingBox() {
    Scene scene = reference::test::cornellBox();
    scene.materials[kGlass].model = Dielectric{1.5, 0, {0.3, 1, 40}};
    scene.render.maxDepth = 6;
    return scene;
}

struct Bundle {
    std::vector<shared::Ray> rays;
    gpu::Array<shared::Ray> device;
    gpu::Array<shared::Hit> hits;
};

// A third of the rays start within the glass ball.
Bundle bundle(BothSides& both, std::uint32_t count) {
    Bundle b;
    reference::test::Random random;
    for (std::uint32_t i = 0; i < count; ++i) {
        const dvec3 origin = i % 3 == 0 ? dvec3(0.42, -0.67, 0.25) + random.inCube(0.18) : random.inCube(0.99);
        b.rays.push_back(toDevice({.origin = origin, .direction = random.direction()}));
    }
    b.device = both.upload(b.rays);
    b.hits = both.room<shared::Hit>(count);
    both.run("trace_closest", shared::TraceClosestArguments{b.device, b.hits, count, both.deviceScene.rootNode, 0, {}},
             count);
    return b;
}

reference::Media listOf(const BothSides& both, std::uint32_t word) {
    return render::mediaOfWord(both.scene, word);
}

} // namespace

TEST_CASE("a word keeps the same list of media as the reference, whatever is entered and left") {
    Scene scene;
    scene.materials.resize(5); // 3 bits each: room for 10
    const std::uint32_t bits = shared::mediumBits(5);
    CHECK(bits == 3);
    CHECK(shared::mediumBits(7) == 3);
    CHECK(shared::mediumBits(8) == 4); // 1111 marks an empty entry
    CHECK(shared::mediaCapacity(bits) == 10);
    reference::Media list;
    std::uint32_t word = shared::kNoMedia;
    for (std::uint32_t i = 0; i < 10000; ++i) {
        const std::uint32_t number = shared::hash(i);
        const std::uint32_t material = number % 5;
        if ((number >> 8) % 2 == 0 && list.list().size() < 10) {
            list.enter(material);
            word = shared::enterMedium(word, material, bits);
        } else {
            list.leave(material);
            word = shared::leaveMedium(word, material, bits);
        }
        REQUIRE(render::mediaWord(scene, list) == word);
        REQUIRE(render::mediaOfWord(scene, word) == list);
    }
}

TEST_CASE("camera paths are absorbed in glass as in the reference, enter it at its front and leave it at its back") {
    Scene scene = absorbingBox();
    scene.render.integrator = "whitted"; // both directions are followed: no random decision that rounding could flip
    scene.render.minWeight = 0;
    BothSides both(scene);
    const std::uint32_t count = 10000;
    const Bundle b = bundle(both, count);
    std::vector<shared::CameraPath> paths;
    for (std::uint32_t i = 0; i < count; ++i) {
        paths.push_back({vec3(0.5, 0.25, 1), i, i, mediaOf(both.scene, i), 0});
    }
    const Bounce bounce = shade(both, b.rays, paths, 1, 0, Ways::All);
    std::size_t inGlass = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const reference::Ray ray = toReference(b.rays[i]);
        const auto hit = reference::traceClosest(both.world, ray);
        if (!hit || hit->object != both.sceneObject(b.hits.host()[i].object)) {
            continue;
        }
        const reference::CameraPath path{dvec3(paths[i].beta), i, listOf(both, mediaOf(both.scene, i))};
        const auto expected = reference::shadeSurface(both.world, ray, *hit, path, 1, 0);
        CHECK(distance(bounce.emitted.host()[i], expected.emitted) < 1e-5);
        if (expected.visible) {
            // t is right to a few 1e-7, a coefficient of 40/m makes 1e-5 of it, of f below 0.1
            CHECK(glm::distance(fAt(both, bounce.visible.host()[i]), reference::receiverAt(*expected.visible).f) <
                  2e-6);
        }
        const std::vector<reference::NextRay> ways = waysOf(expected);
        REQUIRE(bounce.alive.host()[i] == ways.size());
        for (std::size_t way = 0; way < ways.size(); ++way) {
            const shared::CameraPath& actual = bounce.nextPaths.host()[bounce.slot(i, way)];
            CHECK(listOf(both, actual.media) == ways[way].path.media);
            const dvec3 normal = reference::evaluateSurface(both.world, ray, *hit).normal;
            const double condition = conditioning(ray.direction, ways[way].ray.direction, normal);
            CHECK(distance(actual.beta, ways[way].path.beta) * condition < 2e-5);
            inGlass += actual.media == mediaOf(both.scene, 0) ? 1 : 0;
        }
    }
    CHECK(inGlass >
          count / 6); // those that start in the glass ball with the glass for their medium are reflected in it
}

TEST_CASE("the kernels' exponential is accurate to a few roundings wherever it is above zero") {
    // A light of radiance 1 in the plane z = 0, rays towards it from multiples of 1/8 m in glass that absorbs 1/m: the
    // distance and its product with the coefficient are exact, e^-t alone is not. The series is right to 6e-9, and
    // about four roundings of up to 2^-24 each follow: 2.5e-7.
    Scene scene = reference::test::cornellBox();
    scene.materials[kGlass].model = Dielectric{1.5, 0, dvec3(1)};
    scene.objects.clear();
    reference::test::addObject(scene, Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, std::nullopt, dvec3(1));
    BothSides both(scene);
    const std::uint32_t count = 800; // up to 100 m; from 87 on nothing is left
    std::vector<shared::Ray> rays;
    for (std::uint32_t i = 0; i < count; ++i) {
        rays.push_back({vec3(0, 0, static_cast<float>(i + 1) / 8), 3e38F, vec3(0, 0, -1), 0});
    }
    const std::vector<shared::CameraPath> paths(count, {vec3(1), 0, 0, mediaOf(both.scene, 0), 0});
    const Bounce bounce = shade(both, rays, paths, 1, 0, Ways::All);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double t = (i + 1) / 8.0;
        const double expected = t < 87 ? std::exp(-t) : 0;
        CHECK(std::abs(double{bounce.emitted.host()[i].x} - expected) <= 2.5e-7 * expected);
    }
}

TEST_CASE("photons are absorbed in glass as in the reference, and their flux account balances") {
    BothSides both(absorbingBox());
    const std::uint32_t count = 10000;
    const Bundle b = bundle(both, count);
    std::vector<shared::PhotonPath> paths;
    for (std::uint32_t i = 0; i < count; ++i) {
        paths.push_back({vec3(3, 2, 1), i, 4, shared::kPhotonIndirect, mediaOf(both.scene, i)});
    }
    const auto devicePaths = both.upload(paths);
    const auto photons = both.room<shared::Photon>(count);
    const auto fates = both.upload(std::vector<shared::PhotonFate>(count));
    const auto nextRays = both.room<shared::Ray>(count);
    const auto nextPaths = both.room<shared::PhotonPath>(count);
    const auto alive = both.room<shared::uint>(count);
    const reference::PhotonPass pass = reference::progressivePass(both.world, 5);
    const auto& d = both.deviceScene;
    both.run("scatter_photon",
             shared::ScatterPhotonArguments{b.device,
                                            b.hits,
                                            devicePaths,
                                            d.materials,
                                            d.normals,
                                            d.instances,
                                            photons,
                                            fates,
                                            nextRays,
                                            nextPaths,
                                            alive,
                                            count,
                                            0,
                                            2,
                                            both.scene.render.maxDepth,
                                            pass.sequence,
                                            pass.kinds,
                                            1,
                                            shared::kNone,
                                            {}},
             count);
    std::size_t coins = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const shared::PhotonFate& fate = fates.host()[i];
        const vec3 onward = alive.host()[i] != 0 ? nextPaths.host()[i].power : vec3(0);
        CHECK(glm::length(fate.stored + fate.absorbed + fate.escaped + fate.cutOff + onward - paths[i].power) < 1e-6F);
        const reference::Ray ray = toReference(b.rays[i]);
        const auto hit = reference::traceClosest(both.world, ray);
        if (!hit || hit->object != both.sceneObject(b.hits.host()[i].object)) {
            continue;
        }
        const reference::PhotonPath path{dvec3(paths[i].power), i, 4, reference::PhotonKind::Indirect,
                                         listOf(both, mediaOf(both.scene, i))};
        const auto expected = reference::scatterPhoton(both.world, ray, *hit, path, 2, pass);
        if (expected.stored) {
            CHECK(distance(photons.host()[i].power, expected.stored->power) < 2e-5); // as above, of 3 W
        }
        const shared::PhotonPath& actual = nextPaths.host()[i];
        if ((alive.host()[i] != 0) != expected.next.has_value() ||
            (expected.next && listOf(both, actual.media) != expected.path.media)) {
            ++coins; // the random number and the threshold agree to rounding
        } else if (expected.next) {
            CHECK(distance(actual.power, expected.path.power) < 2e-5);
        }
    }
    CHECK(coins <= 2);
}

} // namespace hyalite::testing
