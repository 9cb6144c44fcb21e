// Path tracing's own kernel, and what sample_lights does for it, against their twins.
#include "kernel/every_light.h"
#include "kernel/visible_points.h"
#include "reference/integrators/path.h"
#include "reference/lights/rough_light.h"

#include <algorithm>

namespace hyalite::testing {

namespace {

constexpr std::uint32_t kPoints = 20000;
constexpr std::uint32_t kDepth = 3; // where the paths of interest have just met a surface
constexpr std::uint32_t kPass = 11;

// Points with a normal of their own, coated or not, some of paths that ended elsewhere.
std::vector<shared::VisiblePoint> somePoints(const Scene& scene) {
    reference::test::Random random;
    std::vector<shared::VisiblePoint> points(kPoints);
    for (std::uint32_t i = 0; i < kPoints; ++i) {
        const dvec3 position = random.inCube(0.9);
        points[i] = PointMade{.position = position,
                              .depth = i % 5 == 0 ? i % 3 : kDepth,
                              .normal = glm::normalize(vec3(random.inCube(0.3)) + vec3(0, 0, 1)), // leans against z
                              .samplerSeed = shared::hash(i),
                              .beta = vec3(0.3, 0.2, 0.1) * std::numbers::pi_v<float>,
                              .pixel = i,
                              .material = paintOf(scene, i % 2 != 0)};
    }
    return points;
}

} // namespace

TEST_CASE("paths bounce off diffuse surfaces as in the reference") {
    BothSides both(withPaints(reference::test::cornellBox()));
    both.world.render.maxDepth = 12;
    const auto points = somePoints(both.scene);
    std::vector<shared::CameraPath> paths(kPoints);
    for (std::uint32_t i = 0; i < kPoints; ++i) {
        paths[i] = {vec3(1), i, shared::hash(i), i % 7, 0};
    }
    const auto devicePoints = both.upload(points);
    const auto devicePaths = both.upload(paths);
    const auto rays = both.room<shared::Ray>(kPoints);
    const auto nextPaths = both.room<shared::CameraPath>(kPoints);
    const auto alive = both.upload(std::vector<shared::uint>(kPoints, 0));
    both.run("bounce_paths",
             shared::BouncePathsArguments{devicePaths,
                                          devicePoints,
                                          both.deviceScene.materials,
                                          rays,
                                          nextPaths,
                                          alive,
                                          kPoints,
                                          kDepth,
                                          12,
                                          kPass,
                                          {}},
             kPoints);
    std::size_t coins = 0;
    std::size_t bounced = 0;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
        INFO(i);
        const bool isHere = points[i].depth == kDepth;
        const auto expected = isHere ? reference::bouncePath(both.world, toReference(both, points[i]),
                                                             {.samplerSeed = points[i].samplerSeed}, kPass)
                                     : std::nullopt;
        if (expected.has_value() != (alive.host()[i] != 0)) {
            ++coins; // roulette within a rounding of its threshold, or a direction along the surface
            continue;
        }
        if (!expected) {
            continue;
        }
        ++bounced;
        const shared::CameraPath& path = nextPaths.host()[i];
        CHECK(glm::distance(dvec3(rays.host()[i].direction), expected->ray.direction) < 1e-5);
        CHECK(glm::distance(dvec3(rays.host()[i].origin), expected->ray.origin) == 0);
        // Along the surface a coat's factor is the fifth power of a small difference
        CHECK(glm::distance(dvec3(path.beta), expected->path.beta) < 1e-4 * glm::length(expected->path.beta));
        CHECK(std::abs(path.pdfW - expected->path.pdfW) < 1e-5);
        CHECK(path.pixel == paths[i].pixel);
        CHECK(path.media == paths[i].media);
    }
    CHECK(coins <= 3);
    CHECK(bounced > kPoints / 10);
    // The longest path ends here
    const auto none = both.upload(std::vector<shared::uint>(kPoints, 0));
    both.run("bounce_paths",
             shared::BouncePathsArguments{devicePaths,
                                          devicePoints,
                                          both.deviceScene.materials,
                                          rays,
                                          nextPaths,
                                          none,
                                          kPoints,
                                          kDepth,
                                          kDepth,
                                          kPass,
                                          {}},
             kPoints);
    CHECK(std::ranges::count(none.host(), 0U) == kPoints);
}

TEST_CASE("light sampled for continuing paths is weighted against the light that they may hit themselves") {
    BothSides both(withPaints(everyLight()));
    const auto points = somePoints(both.scene);
    const auto devicePoints = both.upload(points);
    const auto rays = both.room<shared::Ray>(kPoints);
    const auto contributions = both.room<vec3>(kPoints);
    const std::uint32_t maxDepth = both.scene.render.maxDepth;
    both.run("sample_lights",
             shared::SampleLightsArguments{devicePoints,
                                           both.deviceScene.materials,
                                           both.deviceScene.lights,
                                           rays,
                                           contributions,
                                           kPoints,
                                           shared::kNone,
                                           kPass,
                                           maxDepth,
                                           kDepth,
                                           0,
                                           {},
                                           {},
                                           {}},
             kPoints);
    std::size_t coins = 0;
    std::size_t lit = 0;
    std::size_t weighed = 0;
    for (std::uint32_t i = 0; i < kPoints; ++i) {
        INFO(i);
        const bool isHere = points[i].depth == kDepth;
        const auto sample = isHere
                                ? reference::sampleLight(both.world, toReference(both, points[i]), kPass, std::nullopt)
                                : std::nullopt;
        const reference::LightSample twin = sample.value_or(reference::LightSample{});
        const shared::Ray& ray = rays.host()[i];
        if (!sample || ray.tMax == 0) { // on the light's or the surface's horizon either side may reject the sample
            CHECK(glm::length(twin.contribution) < 1e-4);
            CHECK((ray.tMax == 0 || glm::length(contributions.host()[i]) < 1e-4));
            continue;
        }
        const double weight = twin.pdfW > 0 ? reference::powerHeuristic(twin.pdfW, twin.cosine / std::numbers::pi) : 1;
        const dvec3 expected = weight * twin.contribution;
        ++lit;
        weighed += twin.pdfW > 0 ? 1 : 0;
        // Another light, texel or triangle where a random number falls within a rounding of a limit between two;
        // weights of points close to a light magnify the rounding of its distance
        coins += glm::distance(dvec3(contributions.host()[i]), expected) > 2e-3 * glm::length(expected) ? 1 : 0;
    }
    CHECK(coins <= kPoints / 200);
    CHECK(lit > kPoints / 10);
    CHECK(weighed > lit / 10);
}

} // namespace hyalite::testing
