// Pictures of both integrators, device against reference, at equal seed and passes.
#include "kernel/kernel_support.h"
#include "parity/compare_pictures.h"
#include "scene/load/load_scene.h"

#include <filesystem>

namespace hyalite::testing {

TEST_CASE("whitted gives the reference's picture of mirror, glass and a square light") {
    Scene scene = reference::test::cornellBox();
    scene.render.integrator = "whitted";
    scene.camera.resolution = {96, 96};
    // The same numbers decide everything: only a ray past an edge may differ
    comparePictures("whitted-cornell", scene, 0.999);
}

TEST_CASE("whitted follows the tree of rays through many glass spheres and meshes as the reference does") {
    Scene scene = crowdedBox();
    scene.render.integrator = "whitted";
    scene.render.minWeight = 0.01;
    scene.lights = {{{0, 0.2, 0.8}, {0.5, 0.4, 0.3}}, {{0.6, 0.8, 0.2}, {0.2, 0.3, 0.4}}};
    scene.camera.resolution = {64, 64};
    // Several reflections at small spheres multiply rounding errors
    comparePictures("whitted-crowded", scene, 0.99);
}

TEST_CASE("ppm gives the reference's picture of the default scene") {
    Scene scene = loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes/cornell-caustics.yaml");
    scene.camera.resolution = {96, 96};
    scene.render.passes = 16;
    scene.render.photons = 50000;
    scene.render.radius = 0.05;
    // About 300 photons per pixel; one that lands on the rim of the disc on one side only is 0.3 % of its indirect
    // light
    comparePictures("ppm-cornell", scene, 0.99);
}

TEST_CASE("whitted and ppm give the reference's picture of textures and absorbing glass through a lens") {
    Scene scene = loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes/globe.yaml");
    scene.camera.resolution = {96, 72};
    scene.render.passes = 16;
    scene.render.photons = 30000;
    scene.render.radius = 0.08;
    // Of 16 points of the lens one may fall on another tile, whose edge rounding moves
    comparePictures("ppm-globe", scene, 0.98);
    scene.render.integrator = "whitted";
    comparePictures("whitted-globe", scene, 0.98);
}

TEST_CASE("whitted and ppm give the reference's picture of every shape and of CSG") {
    Scene scene = loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes/tests/all-shapes.yaml");
    // Photons that graze one of many curved mirrors and panes of glass land elsewhere; with whichever seed, in some 3 %
    // of the pixels
    comparePictures("ppm-shapes", scene, 0.96);
    scene.render.integrator = "whitted";
    scene.render.minWeight = 0.01;
    comparePictures("whitted-shapes", scene, 0.99);
}

TEST_CASE("whitted and ppm give the reference's picture of every material, smooth and rough") {
    Scene scene = loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes/tests/all-materials.yaml");
    // Photons that come by rough glass and metal land a little aside, on the other side of a disc's rim
    comparePictures("ppm-materials", scene, 0.97);
    scene.render.integrator = "whitted";
    scene.render.minWeight = 0.01;
    comparePictures("whitted-materials", scene, 0.99);
}

TEST_CASE("whitted and ppm give the reference's picture of every light") {
    Scene scene = loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes/tests/all-lights.yaml");
    // As above; and two in a thousand rays see the next texel of the sky or the next triangle of an emitting mesh
    comparePictures("ppm-lights", scene, 0.97);
    scene.render.integrator = "whitted";
    scene.render.minWeight = 0.01;
    comparePictures("whitted-lights", scene, 0.99);
}

TEST_CASE("ppm gives the reference's picture of meshes, point lights and many spheres") {
    Scene scene = crowdedBox();
    scene.lights = {{{0, 0.2, 0.8}, {0.5, 0.4, 0.3}}};
    scene.camera.resolution = {64, 64};
    scene.render.passes = 16;
    scene.render.photons = 30000;
    scene.render.radius = 0.08;
    // As above, with paths that diverge after grazing one of thirty small spheres
    comparePictures("ppm-crowded", scene, 0.97);
}

} // namespace hyalite::testing
