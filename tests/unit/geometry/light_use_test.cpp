// What the tries of the lights make of their intensities and photons.
#include "geometry/light_use.h"
#include "unit/reference/support.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

namespace hyalite {

namespace {

using Catch::Matchers::WithinRel;
using glm::dvec3;

// A hundred points of the same intensity, and a sun.
LightTree hundredPointsAndSun() {
    Scene scene;
    scene.directionals = {{.irradiance = dvec3(1e6)}};
    for (int i = 0; i < 100; ++i) {
        scene.lights.push_back({.position = {i, 0, 0}});
    }
    return buildLightTree(lightExtents(scene));
}

double intensity(const LightTree& tree, std::size_t light) {
    return tree.nodes[tree.leafOf[light]].extent.intensity;
}

} // namespace

TEST_CASE("lights never seen keep an eighth of the intensity of the one that was, however many they are") {
    LightTree tree = hundredPointsAndSun();
    std::vector<LightUse> uses(101, {.brought = 0, .tried = 18, .seen = 0});
    std::size_t sun = 0;
    while (tree.leafOf[sun] >= tree.farCount) {
        ++sun;
    }
    const std::size_t lamp = sun == 7 ? 8 : 7;
    uses[lamp] = {.brought = 1, .tried = 18, .seen = 9};
    const double before = intensity(tree, lamp);
    const double sunBefore = intensity(tree, sun);
    scaleIntensities(tree, uses);
    CHECK_THAT(intensity(tree, lamp), WithinRel(before / 2, 1e-12)); // (9 + 1) / (18 + 2)
    CHECK_THAT(tree.nodes[tree.farCount].extent.intensity, WithinRel(before / 2 * 1.125, 1e-12));
    CHECK_THAT(intensity(tree, sun), WithinRel(sunBefore / 20, 1e-12)); // no far light was seen: nothing to bound it by
}

TEST_CASE("lights never seen, but fewer than would weigh, keep what their tries say") {
    LightTree tree = hundredPointsAndSun();
    std::vector<LightUse> uses(101, {.brought = 1, .tried = 18, .seen = 18});
    uses[3] = {.brought = 0, .tried = 18, .seen = 0};
    const double before = intensity(tree, 3);
    scaleIntensities(tree, uses);
    CHECK_THAT(intensity(tree, 3), WithinRel(before / 20, 1e-12));
}

TEST_CASE("half of the photons follow the light that was found, by its share, and the rest stay as they were") {
    const std::vector<double> pmf{0.5, 0.25, 0.25};
    const std::vector<double> learned = learnedPmf(pmf, {1, 2, 1}, {{.brought = 1}, {.brought = 1}, {.brought = 0}});
    CHECK_THAT(learned[0], WithinRel(0.25 + 0.5 / 3, 1e-12));
    CHECK_THAT(learned[1], WithinRel(0.125 + 1.0 / 3, 1e-12));
    CHECK_THAT(learned[2], WithinRel(0.125, 1e-12));
    CHECK(learnedPmf(pmf, {1, 2, 1}, std::vector<LightUse>(3)) == pmf);
}

} // namespace hyalite
