// sample_lights and emit_photons against their twins, for every kind of light.
#include "kernel/every_light.h"
#include "kernel/visible_points.h"
#include "reference/photons/photons.h"

#include <algorithm>

namespace hyalite::testing {

namespace {

using std::numbers::pi;

// Tolerance on a photon's origin and direction. The environment is sampled from cumulative probabilities accurate to
// 2^-24 each, divided by the smallest probability of a texel in its row or of a row, about 1/100: 1e-5 of a row's
// height, or its square root near a pole, where the height is that of a cosine. A spot's quantile is the cube root of
// such a number at the edge of the cone, a mesh's point the square root of one at a corner of its triangle.
double directionTolerance(const reference::Light& light) {
    const bool isSurrounding = std::holds_alternative<reference::SurroundingLight>(light.shape);
    return isSurrounding ? 5e-3 : std::holds_alternative<SpotLight>(light.shape) ? 1e-3 : 1e-5;
}
double originTolerance(const reference::Light& light) {
    const auto* area = std::get_if<reference::AreaLight>(&light.shape);
    if (area != nullptr && std::holds_alternative<reference::EmittingMesh>(area->shape)) {
        return 5e-4;
    }
    if (std::holds_alternative<reference::SurroundingLight>(light.shape)) {
        return 2e-2; // twice the direction's, times the radius of two of the scene
    }
    return 3e-6;
}

} // namespace

TEST_CASE("light sampling gives the reference's ray and contribution") {
    BothSides both(withPaints(everyLight()));
    reference::test::Random random;
    const std::uint32_t count = 20000;
    std::vector<shared::VisiblePoint> points(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        points[i] = PointMade{.position = random.inCube(0.9),
                              .depth = i % 13,
                              .normal = random.direction(),
                              .samplerSeed = shared::hash(i),
                              .beta = vec3(0.3, 0.2, 0.1) * std::numbers::pi_v<float>,
                              .pixel = i,
                              .material = paintOf(both.scene, i % 2 != 0)};
    }
    const auto devicePoints = both.upload(points);
    const auto rays = both.room<shared::Ray>(count);
    const auto contributions = both.room<vec3>(count);
    const std::uint32_t pass = 9;
    const std::uint32_t lightCount = both.deviceScene.lightCount;
    REQUIRE(lightCount == 13);
    for (std::uint32_t light = shared::kNone; light == shared::kNone || light < lightCount; ++light) {
        INFO("light " << static_cast<int>(light));
        both.run("sample_lights",
                 shared::SampleLightsArguments{devicePoints,
                                               both.deviceScene.materials,
                                               both.deviceScene.lights,
                                               rays,
                                               contributions,
                                               count,
                                               light,
                                               pass,
                                               both.scene.render.maxDepth,
                                               0,
                                               0,
                                               {},
                                               {},
                                               {}},
                 count);
        // The strongest contribution at one metre, both cosines 1: f times intensity or radiance times area, over pmf
        double full = 0;
        for (std::uint32_t i = 0; i < lightCount; ++i) {
            const reference::Light& l = both.world.lights[i];
            if (light == shared::kNone || light == i) {
                const double strength = glm::length(l.power) / (light == shared::kNone ? l.pmf : 1.0) / pi;
                full = std::max(full, glm::length(dvec3(0.3, 0.2, 0.1)) * strength);
            }
        }
        std::size_t lit = 0;
        std::size_t coins = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const shared::VisiblePoint& p = points[i];
            const bool shortEnough = p.depth > 0 && p.depth + 1 <= both.scene.render.maxDepth;
            const reference::VisiblePoint x = toReference(both, p);
            const auto one = light == shared::kNone ? std::nullopt : std::optional<std::uint32_t>(light);
            const auto sample = shortEnough ? reference::sampleLight(both.world, x, pass, one) : std::nullopt;
            const reference::LightSample expected = sample.value_or(reference::LightSample{});
            const shared::Ray& ray = rays.host()[i];
            const vec3 contribution = contributions.host()[i];
            if (!sample || ray.tMax == 0) { // on the light's or the surface's horizon either side may reject the sample
                CHECK(glm::length(expected.contribution) < 1e-4);
                CHECK((ray.tMax == 0 || glm::length(contribution) < 1e-4));
                continue;
            }
            ++lit;
            const double d = glm::length(expected.to - expected.from);
            const bool endless = d == reference::kBeyond || d > 1e20;
            REQUIRE((ray.tMax > 1e30F) == endless);
            const dvec3 direction = (expected.to - expected.from) / d;
            // Another texel or triangle, where a random number is as good as on its border
            if (glm::dot(dvec3(ray.direction), direction) < 1 - 1e-4) {
                ++coins;
                continue;
            }
            // Cosines and distances are right to 2e-6, compared with what both cosines at 1 would let through; of
            // spots the falloff to 1e-5, of meshes and the environment places as above
            const bool coarse = light == shared::kNone || light == 0 || light == 3 || light == 4 || light >= 11;
            const double near = endless      ? 1
                                : light == 6 ? 0.3
                                             : d; // a beam is as strong everywhere: E = flux / (pi r^2)
            CHECK(distance(contribution, expected.contribution) <=
                  (coarse ? 2e-4 : 2e-6) * full / (near * near) * (1 + 1 / near));
            if (endless) {
                CHECK(distance(ray.direction, direction) < 5e-3);
            } else {
                CHECK(distance(ray.origin + ray.tMax * ray.direction, expected.to) < (coarse ? 5e-4 : 3e-6));
            }
        }
        CHECK(lit > count / 50);
        CHECK(coins <= 2);
    }
}

TEST_CASE("no light occludes itself, however near the origin it is and however far the receiver") {
    // Lights whose coordinates do not bound the length of the shadow rays: a square in the plane x = 0, a small ball
    // about the origin and a small mesh
    Scene scene;
    scene.meshes = {sphereMesh(4, false)};
    scene.camera.position = {0, 0, 50};
    reference::test::addObject(scene, Quad{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}, std::nullopt, dvec3(1));
    reference::test::addObject(scene, Sphere{{0.1, -0.5, 0}, 0.01}, std::nullopt, dvec3(1));
    const glm::dmat4 small = glm::scale(glm::translate(glm::dmat4(1), dvec3(0, 0, -0.5)), dvec3(0.01));
    reference::test::addObject(scene, MeshInstance{0, small}, std::nullopt, dvec3(1));
    BothSides both(scene);
    reference::test::Random random;
    const std::uint32_t count = 20000;
    std::vector<shared::VisiblePoint> points(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        // In front of the square with nothing between: the ball and the mesh lie outside of the cone x > 0, y, z in [0,
        // 1]
        const dvec3 position(random.between(0.2, i % 2 == 0 ? 2 : 100), random.unit(), random.unit());
        points[i] = PointMade{.position = position, .normal = {-1, 0, 0}, .samplerSeed = shared::hash(i), .pixel = i};
    }
    const auto devicePoints = both.upload(points);
    const auto rays = both.room<shared::Ray>(count);
    const auto contributions = both.room<vec3>(count);
    for (std::uint32_t light = 0; light < 3; ++light) {
        INFO("light " << light);
        both.run("sample_lights",
                 shared::SampleLightsArguments{devicePoints,
                                               both.deviceScene.materials,
                                               both.deviceScene.lights,
                                               rays,
                                               contributions,
                                               count,
                                               light,
                                               0,
                                               2,
                                               0,
                                               0,
                                               {},
                                               {},
                                               {}},
                 count);
        const auto direct = both.upload(std::vector<vec3>(count, vec3(0)));
        both.run("trace_shadow",
                 shared::TraceShadowArguments{
                     rays, contributions, direct, count, both.deviceScene.rootNode, 0, {}, {}, {}, {}, {}, {}, {}},
                 count);
        std::size_t sent = 0;
        std::size_t blocked = 0;
        std::size_t blockedInReference = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const shared::VisiblePoint& p = points[i];
            const reference::VisiblePoint x = toReference(both, p);
            const auto sample = reference::sampleLight(both.world, x, 0, light);
            // Rays that leave along the surface may pass through adjacent facets
            const bool clear =
                sample &&
                glm::length(sample->contribution) * std::pow(glm::length(sample->to - sample->from), 2) > 1e-6;
            if (clear && rays.host()[i].tMax > 0) {
                ++sent;
                blocked += direct.host()[i] == vec3(0) ? 1 : 0;
                blockedInReference += reference::traceShadow(both.world, sample->from, sample->to) ? 0 : 1;
            }
        }
        CHECK(sent > count / 4);
        CHECK(blocked == 0);
        CHECK(blockedInReference == 0);
    }
}

TEST_CASE("photons leave the lights as in the reference, by the lights' pmf") {
    Scene scene = everyLight();
    scene.render.photons = 40000;
    BothSides both(scene);
    const std::uint32_t count = scene.render.photons;
    const auto rays = both.room<shared::Ray>(count);
    const auto paths = both.room<shared::PhotonPath>(count);
    const auto pass = reference::progressivePass(both.world, 2);
    both.run("emit_photons",
             shared::EmitPhotonsArguments{both.deviceScene.lights, rays, paths, 0, count, count,
                                          both.deviceScene.lightCount, pass.sequence},
             count);
    std::vector<dvec3> flux(both.world.lights.size(), dvec3(0));
    std::vector<std::uint32_t> emitted(both.world.lights.size(), 0);
    std::size_t coins = 0;
    double furthest = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const reference::Emission expected = reference::emitPhoton(both.world, i, pass);
        const shared::Ray& ray = rays.host()[i];
        const shared::PhotonPath& path = paths.host()[i];
        CHECK(path.photon == i);
        flux.at(path.light) += dvec3(path.power);
        ++emitted.at(path.light);
        if (path.light != expected.light || distance(path.power, expected.power) > 1e-3 * glm::length(expected.power) ||
            distance(ray.origin, expected.ray.origin) > 0.03) { // the next light, texel or triangle
            ++coins;
            continue;
        }
        INFO("light " << path.light);
        const reference::Light& light = both.world.lights[expected.light];
        CHECK(distance(ray.origin, expected.ray.origin) < originTolerance(light));
        CHECK(distance(ray.direction, expected.ray.direction) < directionTolerance(light));
        furthest += distance(ray.direction, expected.ray.direction) / count;
        CHECK(distance(path.power, expected.power) < 1e-5 * glm::length(expected.power));
    }
    CHECK(coins <= 3);
    CHECK(furthest < 1e-5); // on average all are good to rounding
    // Every light's flux: 4 pi I for points, 2 pi I (1 - cos) for a spot without a blend, E pi r^2 for a beam, pi A L
    // for surfaces. The choice of lights is stratified over the photons: right to a photon or two of each light.
    const auto check = [&](std::size_t light, const dvec3& expected) {
        INFO("light " << light);
        REQUIRE(emitted[light] > 100);
        CHECK(glm::length(flux[light] - expected) < 2.5 / emitted[light] * glm::length(expected));
    };
    check(1, 4 * pi * dvec3(1, 2, 3));
    check(4, 2 * pi * (1 - std::cos(pi / 9)) * dvec3(7, 9, 3));
    check(6, 0.09 * pi * dvec3(9));
    check(7, pi * 0.25 * dvec3(18.4, 15.6, 8));
    check(8, pi * glm::length(glm::cross(dvec3(0, 0.4, 0), dvec3(0, 0.1, 0.6))) * dvec3(3, 2, 9));
    check(9, pi * pi * glm::length(glm::cross(dvec3(0.2, 0, 0), dvec3(0, 0.05, 0.3))) * dvec3(5, 5, 2));
    check(10, 4 * pi * 0.0225 * pi * dvec3(2, 6, 3));
    // The environment's photons differ in colour: five standard errors of such as deviate by half their mean
    CHECK(glm::length(flux[0] - both.world.lights[0].power) <
          5 * 0.5 / std::sqrt(emitted[0]) * glm::length(both.world.lights[0].power));
}

TEST_CASE("no flux of any light is lost: it is stored, absorbed, cut off, escaped or still in flight") {
    Scene scene = everyLight();
    scene.render.photons = 20000;
    BothSides both(scene);
    const std::uint32_t count = scene.render.photons;
    const auto& d = both.deviceScene;
    const auto rays = both.room<shared::Ray>(count);
    const auto paths = both.room<shared::PhotonPath>(count);
    const auto hits = both.room<shared::Hit>(count);
    const auto photons = both.room<shared::Photon>(count);
    const auto fates = both.room<shared::PhotonFate>(count);
    const auto nextRays = both.room<shared::Ray>(count);
    const auto nextPaths = both.room<shared::PhotonPath>(count);
    const auto alive = both.room<shared::uint>(count);
    std::ranges::fill(fates.host(), shared::PhotonFate{});
    both.run("emit_photons", shared::EmitPhotonsArguments{d.lights, rays, paths, 0, count, count, d.lightCount, 17},
             count);
    both.run("trace_closest", shared::TraceClosestArguments{rays, hits, count, d.rootNode, 0, {}}, count);
    both.run("scatter_photon",
             shared::ScatterPhotonArguments{
                 rays,          hits,  paths, d.materials, d.normals, d.instances,           photons, fates, nextRays,
                 nextPaths,     alive, count, 0,           1,         scene.render.maxDepth, 17,      7,     1,
                 shared::kNone, {}},
             count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const shared::PhotonFate& fate = fates.host()[i];
        const vec3 onward = alive.host()[i] != 0 ? nextPaths.host()[i].power : vec3(0);
        const vec3 power = paths.host()[i].power;
        CHECK(glm::length(fate.stored + fate.absorbed + fate.escaped + fate.cutOff + onward - power) <=
              1e-6F * glm::length(power));
    }
}

} // namespace hyalite::testing
