// A box lit by every kind of light, for the tests that compare lights on both sides.
#pragma once

#include "kernel/kernel_support.h"

namespace hyalite::testing {

// Colours of very different strength, some black.
inline Environment patchwork() {
    Environment environment{.image = Image(12, 6), .scale = 0.7, .rotation = 75};
    reference::test::Random random;
    for (vec3& pixel : environment.image.pixels) {
        const double strength = random.unit() < 0.2 ? 0 : random.between(0.1, 4);
        pixel = strength * dvec3(random.between(0.5, 1), random.between(0.5, 1), random.between(0.5, 1));
    }
    return environment;
}

// In the order of the lights: the environment, two points, two spots, light from everywhere and a beam, and the
// objects: a quad, another one, a disk stretched to an ellipse, a sphere, a mesh and its mirror image.
inline Scene everyLight() {
    Scene scene = reference::test::cornellBox();
    scene.environment = patchwork();
    scene.lights = {{{0.2, 0.5, 0.1}, {1, 2, 3}}, {{-0.7, -0.1, 0.3}, {4, 1, 0.5}}};
    scene.spots = {{.position = {0.3, 0.9, 0.2},
                    .direction = glm::normalize(dvec3(-0.3, -1, 0.1)),
                    .intensity = {9, 5, 3},
                    .angle = 50,
                    .blend = 0.6},
                   {.position = {-0.5, 0.9, 0.6}, .intensity = {7, 9, 3}, .angle = 20, .blend = 0, .photonShare = 3}};
    scene.directionals = {{.direction = glm::normalize(dvec3(0.2, -1, -0.7)), .irradiance = {2, 1, 1}},
                          {.direction = glm::normalize(dvec3(0.1, 0.2, -1)),
                           .irradiance = dvec3(9),
                           .beam = DirectionalLight::Beam{{0, 0, 2}, 0.3}}};
    reference::test::addObject(scene, Quad{{-0.99, -0.2, -0.3}, {0, 0.4, 0}, {0, 0.1, 0.6}}, std::nullopt, {3, 2, 9});
    reference::test::addObject(scene, Disk{{0.5, 0.9, -0.5}, {0.2, 0, 0}, {0, 0.05, 0.3}}, std::nullopt, {5, 5, 2});
    reference::test::addObject(scene, Sphere{{-0.5, 0.5, 0.5}, 0.15}, std::nullopt, {2, 6, 3});
    scene.meshes = {sphereMesh(4, false)};
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), dvec3(0.5, 0.1, -0.4));
    reference::test::addObject(scene, MeshInstance{0, glm::scale(moved, dvec3(0.2, 0.1, 0.3))}, std::nullopt,
                               {6, 2, 2});
    const glm::dmat4 turned = glm::rotate(glm::translate(glm::dmat4(1), dvec3(-0.5, -0.2, -0.6)), 0.7, dvec3(0, 0, 1));
    reference::test::addObject(scene, MeshInstance{0, glm::scale(turned, dvec3(0.1, -0.2, 0.1))}, std::nullopt,
                               {1, 9, 9});
    return scene;
}

} // namespace hyalite::testing
