// The hierarchy over the lights: its bounds hold, and every light keeps its share of the picks at every receiver.
#include "geometry/light_tree.h"
#include "reference/lights/light_choice.h"
#include "reference/world.h"
#include "unit/reference/support.h"

#include "shaders/shared/limits.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace hyalite {

namespace {

using glm::dvec3;
using std::numbers::pi;

// Lights of every kind in a box of 4 m, then `points` more points.
Scene manyLights(std::size_t points) {
    Scene scene = reference::test::cornellBox();
    reference::test::Random random;
    scene.environment = Environment{.image = Image(1, 1)};
    scene.environment->image.at(0, 0) = glm::vec3(0.1F);
    scene.spots = {{.position = {0.3, 0.9, 0.2}, .direction = {0, -1, 0}, .intensity = {9, 5, 3}, .angle = 20}};
    scene.directionals = {
        {.direction = {0, -1, 0}, .irradiance = dvec3(1e6)},
        {.direction = {0, 0, -1}, .irradiance = dvec3(9), .beam = DirectionalLight::Beam{{0, 0, 2}, 0.3}}};
    reference::test::addObject(scene, Disk{{0.5, 0.9, -0.5}, {0.2, 0, 0}, {0, 0.05, 0.3}}, std::nullopt, {5, 5, 2});
    reference::test::addObject(scene, Sphere{{-0.5, 0.5, 0.5}, 0.15}, std::nullopt, {2, 6, 3});
    scene.meshes = {{.file = {},
                     .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                     .normals = {},
                     .triangles = {{0, 1, 2}, {0, 3, 1}},
                     .uvs = {},
                     .lines = {}}};
    reference::test::addObject(scene, MeshInstance{0, glm::scale(glm::dmat4(1), dvec3(0.3, -0.2, 0.4))}, std::nullopt,
                               dvec3(2));
    for (std::size_t i = 0; i < points; ++i) {
        scene.lights.push_back({random.inCube(2), dvec3(std::pow(10, random.between(-6, 6)))});
    }
    return scene;
}

double angle(const dvec3& a, const dvec3& b) {
    return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

} // namespace

TEST_CASE("every light is within its bounds: where its rays start, and where to they go") {
    const Scene scene = manyLights(3);
    const std::vector<LightExtent> extents = lightExtents(scene);
    const std::vector<reference::Light> lights = reference::makeLights(scene);
    REQUIRE(extents.size() == lights.size());
    reference::test::Random random;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        INFO("light " << i);
        const LightExtent& e = extents[i];
        CHECK(e.isFar == (reference::originDensity(lights[i], e.center, e.axis) > 0));
        for (int n = 0; n < 200 && !e.isFar; ++n) {
            const auto numbers = [&] { return glm::dvec2(random.unit(), random.unit()); };
            const reference::LightRay ray = emitFrom(lights[i], numbers(), numbers());
            REQUIRE(glm::length(ray.origin - e.center) <= e.radius * (1 + 1e-9));
            const bool isSpot = std::holds_alternative<SpotLight>(lights[i].shape);
            REQUIRE(angle(ray.direction, e.axis) <= e.spread + (isSpot ? 0 : e.fade) + 1e-6);
        }
    }
}

TEST_CASE("a node's bounds hold its children's, and every light is one leaf") {
    Scene scene = manyLights(200);
    for (int i = 0; i < 64; ++i) { // all in one place
        scene.lights.push_back({{0.5, 0.5, 0.5}, dvec3(1)});
    }
    const std::vector<LightExtent> extents = lightExtents(scene);
    const LightTree tree = buildLightTree(extents);
    std::vector<int> leaves(extents.size(), 0);
    for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
        const LightTree::Node& node = tree.nodes[n];
        if (node.second == 0) {
            ++leaves.at(node.light);
            CHECK(tree.leafOf.at(node.light) == n);
            CHECK((n < tree.farCount) == extents[node.light].isFar);
            continue;
        }
        double intensity = 0;
        for (const std::uint32_t child : {n + 1, node.second}) {
            const LightExtent& inner = tree.nodes.at(child).extent;
            CHECK(tree.nodes[child].parent == n);
            intensity += inner.intensity;
            // The corners of its box, and the rim of its cone
            CHECK(glm::length(inner.box.low - node.extent.center) <= node.extent.radius + 1e-9);
            CHECK(glm::length(inner.box.high - node.extent.center) <= node.extent.radius + 1e-9);
            CHECK((node.extent.spread >= pi ||
                   angle(inner.axis, node.extent.axis) + inner.spread <= node.extent.spread + 1e-6));
            CHECK(inner.fade <= node.extent.fade);
        }
        CHECK(std::abs(intensity / node.extent.intensity - 1) < 1e-9);
    }
    CHECK(std::ranges::all_of(leaves, [](int count) { return count == 1; }));
    CHECK(std::abs(tree.nodes.at(tree.farCount).extent.intensity - 1) < 1e-9);
    std::uint32_t depth = 0;
    for (const std::uint32_t leaf : tree.leafOf) {
        std::uint32_t steps = 0;
        for (std::uint32_t n = leaf; tree.nodes[n].parent != shared::kNone; n = tree.nodes[n].parent) {
            ++steps;
        }
        depth = std::max(depth, steps);
    }
    CHECK(depth <= 40); // each side has an eighth at least: log 270 / log (8/7) = 42
}

TEST_CASE("at every receiver the probabilities of the picks add up to 1, and none is below its floor") {
    for (const std::size_t points : {0U, 1U, 300U}) {
        const reference::World world = reference::prepareWorld(manyLights(points));
        const std::size_t count = world.lights.size();
        reference::test::Random random;
        for (int i = 0; i < 50; ++i) {
            // Also exactly at a light
            const dvec3 receiver = i == 0 ? dvec3(0.3, 0.9, 0.2) : random.inCube(3);
            double sum = 0;
            for (std::uint32_t light = 0; light < count; ++light) {
                const double pmf = reference::pickProbability(world, light, receiver);
                // A quarter of the picks by pmf, half of that even
                REQUIRE(pmf >= 0.999 / (8 * static_cast<double>(count)));
                sum += pmf;
            }
            REQUIRE(std::abs(sum - 1) < 1e-9);
        }
    }
}

TEST_CASE("a light's picks are as frequent as their probability says, which a pick reports too") {
    const reference::World world = reference::prepareWorld(manyLights(20));
    constexpr int kSide = 400; // even points of the unit square: errors of a few parts in 400
    const dvec3 receiver(-0.4, -0.9, 0.6);
    std::vector<double> counts(world.lights.size(), 0);
    for (int i = 0; i < kSide * kSide; ++i) {
        const glm::dvec2 uv((i % kSide + 0.5) / kSide, (static_cast<double>(i / kSide) + 0.5) / kSide);
        const reference::LightPick pick = reference::pickLightAt(world, receiver, uv);
        REQUIRE(pick.pmf == reference::pickProbability(world, pick.light, receiver));
        counts.at(pick.light) += 1.0 / (kSide * kSide);
    }
    for (std::uint32_t light = 0; light < counts.size(); ++light) {
        CHECK(std::abs(counts[light] - reference::pickProbability(world, light, receiver)) < 3.0 / kSide);
    }
}

} // namespace hyalite
