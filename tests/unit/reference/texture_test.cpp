// Textures against their definition.
#include "reference/textures/texture.h"

#include "reference/world.h"
#include "unit/reference/support.h"

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

// Two by two: red above green on the left, blue above white on the right.
ImageTexture fourTexels() {
    Image image(2, 2);
    image.at(0, 0) = {1, 0, 0};
    image.at(1, 0) = {0, 0, 1};
    image.at(0, 1) = {0, 1, 0};
    image.at(1, 1) = {1, 1, 1};
    return {std::make_shared<const Image>(image)};
}

// What a ray sees of an object with the texture coordinates as colour: (u, v, -).
dvec2 coordinatesSeen(const Scene& scene, const dvec3& from, const dvec3& to) {
    const World world = prepareWorld(scene);
    const Ray ray{.origin = from, .direction = glm::normalize(to - from)};
    const auto hit = traceClosest(world, ray);
    REQUIRE(hit);
    return evaluateSurface(world, ray, *hit).uv;
}

void checkUv(const dvec2& actual, const dvec2& expected) {
    INFO(actual.x << ' ' << actual.y << " for " << expected.x << ' ' << expected.y);
    CHECK(glm::length(actual - expected) < 1e-12);
}

Scene sceneOf(const Shape& shape) {
    Scene scene = onePixel({0, 0, 5}, {0, 0, 0}, "ppm");
    addObject(scene, shape, std::nullopt);
    return scene;
}

} // namespace

TEST_CASE("an image has its texels' colours at their centres and interpolates linearly between") {
    const TextureModel image = fourTexels();
    const auto at = [&](double u, double v) { return evaluateTexture(image, {u, v}, dvec3(0)); };
    checkNear(at(0.25, 0.75), {1, 0, 0}, 1e-15); // upper left: v points up
    checkNear(at(0.75, 0.75), {0, 0, 1}, 1e-15);
    checkNear(at(0.25, 0.25), {0, 1, 0}, 1e-15);
    checkNear(at(0.75, 0.25), {1, 1, 1}, 1e-15);
    checkNear(at(0.5, 0.75), {0.5, 0, 0.5}, 1e-15);
    checkNear(at(0.5, 0.5), {0.5, 0.5, 0.5}, 1e-15); // the mean of the four
    checkNear(at(0.375, 0.75), {0.75, 0, 0.25}, 1e-15);
}

TEST_CASE("an image repeats, and its edges blend with the opposite ones") {
    const TextureModel image = fourTexels();
    Random random;
    for (int i = 0; i < 100; ++i) {
        const dvec2 uv(random.unit(), random.unit());
        const dvec2 elsewhere = uv + dvec2(std::floor(random.between(-5, 5)), std::floor(random.between(-5, 5)));
        checkNear(evaluateTexture(image, uv, dvec3(0)), evaluateTexture(image, elsewhere, dvec3(0)), 1e-13);
    }
    // On the left edge half of each, at the height of the upper row's middle
    checkNear(evaluateTexture(image, {0, 0.75}, dvec3(0)), {0.5, 0, 0.5}, 1e-15);
}

TEST_CASE("a checker changes its colour at each of its planes") {
    const Checker checker{.colors = {dvec3(0), dvec3(1)}, .size = 0.5, .inWorld = true};
    const auto at = [&](const dvec3& p) { return evaluateTexture(checker, {}, p).x; };
    CHECK(at({0.25, 0.25, 0.25}) == 0);
    CHECK(at({0.75, 0.25, 0.25}) == 1);
    CHECK(at({0.75, 0.75, 0.25}) == 0);
    CHECK(at({0.75, 0.75, 0.75}) == 1);
    CHECK(at({-0.25, 0.25, 0.25}) == 1); // also beyond the origin
    CHECK(at({-0.75, -0.25, 0.25}) == 1);
    // On a plane, and a rounding error to either side of it, the colour is that of the cell above
    CHECK(at({0.25, 0.5, 0.25}) == 1);
    CHECK(at({0.25, 0.5 - 1e-9, 0.25}) == 1);
}

TEST_CASE("a checker of surface coordinates repeats in u and v") {
    const Checker checker{.colors = {dvec3(0), dvec3(1)}, .size = 0.25, .inWorld = false};
    const auto at = [&](const dvec2& uv) { return evaluateTexture(checker, uv, {9, 9, 9}).x; };
    CHECK(at({0.1, 0.1}) == 0);
    CHECK(at({0.3, 0.1}) == 1);
    CHECK(at({0.3, 0.3}) == 0);
    CHECK(at({0.9, 0.1}) == 1);
}

TEST_CASE("quads, disks, spheres and meshes have the coordinates that the documentation says") {
    const Scene quad = sceneOf(Quad{{-1, -1, 0}, {2, 0, 0}, {0, 4, 0}});
    checkUv(coordinatesSeen(quad, {0.5, 2, 5}, {0.5, 2, 0}), {0.75, 0.75});
    // The square around the disk
    const Scene disk = sceneOf(Disk{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}});
    checkUv(coordinatesSeen(disk, {1, -1, 5}, {1, -1, 0}), {0.75, 0.25});
    // The middle of the image faces +z, its right half +x; v is the latitude
    const Scene sphere = sceneOf(Sphere{{1, 0, 0}, 2});
    checkUv(coordinatesSeen(sphere, {1, 0, 9}, {1, 0, 0}), {0.5, 0.5});
    checkUv(coordinatesSeen(sphere, {9, 0, 0}, {1, 0, 0}), {0.75, 0.5});
    checkUv(coordinatesSeen(sphere, {-9, 0, 0}, {1, 0, 0}), {0.25, 0.5});
    checkUv(coordinatesSeen(sphere, {1, 9, 9}, {1, 0, 0}), {0.5, 0.75}); // 45 degrees north
    CHECK(std::abs(coordinatesSeen(sphere, {1, 9, 0}, {1, 0, 0}).y - 1) < 1e-12);
    // From within it is the same point of the surface
    checkUv(coordinatesSeen(sphere, {1, 0, 0}, {3, 0, 0}), {0.75, 0.5});

    Scene mesh = sceneOf(MeshInstance{0, glm::dmat4(1)});
    mesh.meshes.push_back({.file = {},
                           .positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                           .normals = {},
                           .triangles = {{0, 1, 2}},
                           .uvs = {{0, 0}, {2, 0}, {0, 8}}});
    checkUv(coordinatesSeen(mesh, {1, 1, 5}, {1, 1, 0}), {0.5, 2});
}

TEST_CASE("a texture multiplies the colour of diffuse surfaces and mirrors") {
    Scene scene = onePixel({0, 0, 5}, {0, 0, 0}, "ppm");
    scene.textures.push_back({"t", fourTexels()});
    const auto modelSeen = [&](const MaterialModel& model) {
        scene.materials = {{.name = {}, .model = model, .colorTexture = 0, .roughnessTexture = {}}};
        scene.objects.clear();
        addObject(scene, Quad{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 0);
        const World world = prepareWorld(scene);
        const Ray ray{.origin = {0.25, 0.25, 1}, .direction = {0, 0, -1}};
        return texturedModel(world, evaluateSurface(world, ray, traceClosest(world, ray).value()));
    };
    checkNear(modelSeen(Diffuse{{0.5, 0.25, 1}}).color, {0, 0.25, 0}, 1e-15);
    checkNear(modelSeen(Mirror{{0.5, 0.75, 1}}).color, {0, 0.75, 0}, 1e-15);
    checkNear(modelSeen(MetallicRoughness{{0.5, 0.75, 1}}).color, {0, 0.75, 0}, 1e-15);
}

TEST_CASE("a texture's green multiplies the roughness, its blue the metallic") {
    Scene scene = onePixel({0, 0, 5}, {0, 0, 0}, "ppm");
    scene.textures.push_back({"t", Checker{.colors = {dvec3(0.9, 0.25, 0.5), dvec3(0)}, .size = 10}});
    scene.materials = {
        {.name = {}, .model = MetallicRoughness{dvec3(0.8), 0.5, 0.75}, .colorTexture = {}, .roughnessTexture = 0}};
    addObject(scene, Quad{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 0);
    const World world = prepareWorld(scene);
    const Ray ray{.origin = {0.25, 0.25, 1}, .direction = {0, 0, -1}};
    const MaterialModel model = texturedModel(world, evaluateSurface(world, ray, traceClosest(world, ray).value()));
    CHECK(model.color == dvec3(0.8));
    CHECK(model.roughness == 0.75 * 0.25);
    CHECK(model.metallic == 0.5 * 0.5);
}
