// Values of valid scene files: the shipped scenes, defaults, and shapes baked through hand-derived transforms.
#include "unit/scene/scene_test_support.h"

#include "scene/model/bounds.h"

#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace hyalite;
using namespace hyalite::test;

namespace {

void checkNear(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance = 1e-12) {
    INFO("(" << actual.x << ", " << actual.y << ", " << actual.z << ") against (" << expected.x << ", " << expected.y
             << ", " << expected.z << ")");
    CHECK(glm::length(actual - expected) <= tolerance);
}

Object loadObject(const std::string& shape, const std::string& transform) {
    return loadWithShape(shape, transform).objects.at(0);
}

Sphere loadSphere(const std::string& transform) {
    return std::get<Sphere>(loadObject("{type: sphere, center: [1, 2, 3], radius: 0.5}", transform).shape);
}

Quad loadQuad(const std::string& transform) {
    return std::get<Quad>(
        loadObject("{type: quad, corner: [0, 0, 0], edges: [[1, 0, 0], [0, 1, 0]]}", transform).shape);
}

glm::dvec3 normalOf(const Quad& quad) {
    return glm::normalize(glm::cross(quad.edge0, quad.edge1));
}

} // namespace

TEST_CASE("the default scene is the Cornell box that other renderers were measured on") {
    const Scene scene = loadScene(kSourceFolder / "scenes/cornell-caustics.yaml");
    CHECK(scene.camera.position == glm::dvec3(0, 0, 3.9));
    CHECK(scene.camera.lookAt == glm::dvec3(0, 0, 0));
    CHECK(scene.camera.fov == 39.3);
    CHECK(scene.camera.resolution == glm::uvec2(512, 512));
    CHECK(scene.render.integrator == "ppm");
    CHECK(scene.render.maxDepth == 12);
    CHECK(scene.lights.empty());
    REQUIRE(scene.objects.size() == 8);

    // Walls: a point of the plane, the inward normal, the albedo.
    struct Wall {
        glm::dvec3 point;
        glm::dvec3 normal;
        glm::dvec3 albedo;
    };
    const glm::dvec3 white(0.725, 0.71, 0.68);
    const std::vector<Wall> walls{{{0, -1, 0}, {0, 1, 0}, white},
                                  {{0, 1, 0}, {0, -1, 0}, white},
                                  {{0, 0, -1}, {0, 0, 1}, white},
                                  {{-1, 0, 0}, {1, 0, 0}, {0.63, 0.065, 0.05}},
                                  {{1, 0, 0}, {-1, 0, 0}, {0.14, 0.45, 0.091}}};
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const auto& quad = std::get<Quad>(scene.objects[i].shape);
        checkNear(normalOf(quad), walls[i].normal);
        checkNear(quad.corner + (quad.edge0 + quad.edge1) / 2.0, walls[i].point);
        CHECK(glm::length(quad.edge0) == 2);
        CHECK(glm::length(quad.edge1) == 2);
        CHECK(scene.materials.at(scene.objects[i].material.value()).model.color == walls[i].albedo);
    }

    const Object& light = scene.objects[5];
    const auto& square = std::get<Quad>(light.shape);
    checkNear(normalOf(square), {0, -1, 0}); // it faces down
    checkNear(square.corner + (square.edge0 + square.edge1) / 2.0, {0, 0.999, 0});
    CHECK(glm::length(square.edge0) == 0.5);
    CHECK(glm::length(square.edge1) == 0.5);
    CHECK(light.emission == glm::dvec3(18.4, 15.6, 8));
    CHECK_FALSE(light.material.has_value());

    const auto& mirror = std::get<Sphere>(scene.objects[6].shape);
    CHECK(mirror.center == glm::dvec3(-0.42, -0.67, -0.28));
    CHECK(mirror.radius == 0.33);
    CHECK(scene.materials.at(scene.objects[6].material.value()).model.color == glm::dvec3(0.9));
    const auto& glass = std::get<Sphere>(scene.objects[7].shape);
    CHECK(glass.center == glm::dvec3(0.42, -0.67, 0.25));
    CHECK(glass.radius == 0.33);
    CHECK(scene.materials.at(scene.objects[7].material.value()).model.ior == 1.5);

    // The box [-1, 1]^3 has the diagonal 2 sqrt(3).
    CHECK_THAT(sceneRadius(scene), WithinRel(std::sqrt(3.0), 1e-15));
}

TEST_CASE("every shipped scene loads, and stays where it is unless its name says that it is far away") {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kSourceFolder / "scenes")) {
        if (entry.path().extension() == ".yaml") {
            INFO(entry.path());
            const Scene scene = loadScene(entry.path());
            CHECK_FALSE(scene.objects.empty());
            CHECK((scene.origin != glm::dvec3(0)) == entry.path().filename().string().starts_with("far-"));
            ++count;
        }
    }
    CHECK(count >= 5);
}

TEST_CASE("a key that is absent keeps its documented default") {
    TemporaryFolder folder;
    const Scene scene = loadScene(folder.write("scene.yaml", R"(hyalite: 1
lights: [{type: point, position: [0, 1, 0]}]
materials: {a: {type: diffuse}, b: {type: mirror}, c: {type: dielectric}}
objects: [{shape: {type: sphere, radius: 2}, material: b}]
)"));
    CHECK(scene.camera.position == glm::dvec3(0, 0, 5));
    CHECK(scene.camera.lookAt == glm::dvec3(0, 0, 0));
    CHECK(scene.camera.up == glm::dvec3(0, 1, 0));
    CHECK(scene.camera.fov == 45);
    CHECK(scene.camera.resolution == glm::uvec2(512, 512));
    CHECK(scene.render.integrator == "ppm");
    CHECK(scene.render.maxDepth == 12);
    CHECK(scene.render.passes == 64);
    CHECK(scene.render.photons == 200000);
    CHECK(scene.render.seed == 1);
    CHECK(scene.render.radius == 0);
    CHECK(scene.render.alpha == 2.0 / 3);
    CHECK(scene.render.minWeight == 1.0 / 1024);
    CHECK(scene.lights.at(0).intensity == glm::dvec3(1));
    CHECK(scene.materials.at(0).model.color == glm::dvec3(0.5));
    CHECK(scene.materials.at(1).model.color == glm::dvec3(1));
    CHECK(scene.materials.at(2).model.ior == 1.5);
    CHECK(scene.materials.at(2).model.roughness == 0);
    CHECK(std::get<Sphere>(scene.objects.at(0).shape).center == glm::dvec3(0));
    CHECK(scene.objects.at(0).material == 1);
    CHECK(scene.objects.at(0).where.line == 4);
    CHECK(scene.objects.at(0).where.column == 11);
}

TEST_CASE("every key is read into its place") {
    TemporaryFolder folder;
    const Scene scene = loadScene(folder.write("scene.yaml", R"(hyalite: 1
camera: {position: [1, 2, 3], look_at: [4, 5, 6.5], up: [0, 0, -1], fov: 60.5, resolution: [640, 480]}
render: {integrator: whitted, max_depth: 0, passes: 2, photons: 3, seed: 4, radius: 0.5, alpha: .25, min_weight: 0}
materials: {a: {type: diffuse, albedo: [0, +0.5, 1e0]}}
lights: [{type: point, position: [7, 8, 9], intensity: 2}, {type: point, position: [1, 1, 1], intensity: [0, 1, 0]}]
objects: [{shape: {type: quad, corner: [-1, -.5, 0], edges: [[1, 0, 0], [0, 0, 2]]}, emission: [1, 2, 3], material: a}]
)"));
    CHECK(scene.camera.position == glm::dvec3(1, 2, 3));
    CHECK(scene.camera.lookAt == glm::dvec3(4, 5, 6.5));
    CHECK(scene.camera.up == glm::dvec3(0, 0, -1));
    CHECK(scene.camera.fov == 60.5);
    CHECK(scene.camera.resolution == glm::uvec2(640, 480));
    CHECK(scene.render.integrator == "whitted");
    CHECK(scene.render.maxDepth == 0);
    CHECK(scene.render.passes == 2);
    CHECK(scene.render.photons == 3);
    CHECK(scene.render.seed == 4);
    CHECK(scene.render.radius == 0.5);
    CHECK(scene.render.alpha == 0.25);
    CHECK(scene.render.minWeight == 0);
    CHECK(scene.materials.at(0).name == "a");
    CHECK(scene.materials.at(0).model.color == glm::dvec3(0, 0.5, 1));
    REQUIRE(scene.lights.size() == 2);
    CHECK(scene.lights[0].position == glm::dvec3(7, 8, 9));
    CHECK(scene.lights[0].intensity == glm::dvec3(2));
    CHECK(scene.lights[1].intensity == glm::dvec3(0, 1, 0));
    const auto& quad = std::get<Quad>(scene.objects.at(0).shape);
    CHECK(quad.corner == glm::dvec3(-1, -0.5, 0));
    CHECK(quad.edge0 == glm::dvec3(1, 0, 0));
    CHECK(quad.edge1 == glm::dvec3(0, 0, 2));
    CHECK(scene.objects.at(0).emission == glm::dvec3(1, 2, 3));
    CHECK(scene.objects.at(0).material == 0);
}

TEST_CASE("a scene in JSON and one with anchors read like YAML written out") {
    TemporaryFolder folder;
    const Scene json = loadScene(folder.write("scene.json", R"({
  "hyalite": 1,
  "lights": [{"type": "point", "position": [0, 1.5, 0]}],
  "materials": {"gray": {"type": "diffuse", "albedo": [0.25, 0.5, 0.75]}},
  "objects": [{"shape": {"type": "sphere", "radius": 2.5e-1}, "material": "gray"}]
})"));
    CHECK(json.lights.at(0).position == glm::dvec3(0, 1.5, 0));
    CHECK(std::get<Sphere>(json.objects.at(0).shape).radius == 0.25);

    const Scene anchors = loadScene(folder.write("scene.yaml", R"(hyalite: 1
lights: [{type: point, position: &here [0, 1.5, 0]}]
materials: {gray: {type: diffuse}}
objects: [{shape: {type: sphere, center: *here, radius: 1}, material: gray}]
)"));
    CHECK(std::get<Sphere>(anchors.objects.at(0).shape).center == glm::dvec3(0, 1.5, 0));
}

TEST_CASE("transforms are applied in the order of the list") {
    // Scaling first: 2 (1, 2, 3) + (10, 0, 0). Moving first: 2 ((1, 2, 3) + (10, 0, 0)).
    const Sphere scaledFirst = loadSphere("[{scale: 2}, {translate: [10, 0, 0]}]");
    checkNear(scaledFirst.center, {12, 4, 6});
    CHECK_THAT(scaledFirst.radius, WithinAbs(1, 1e-12));
    const Sphere movedFirst = loadSphere("[{translate: [10, 0, 0]}, {scale: 2}]");
    checkNear(movedFirst.center, {22, 4, 6});
    CHECK_THAT(movedFirst.radius, WithinAbs(1, 1e-12));
}

TEST_CASE("rotations turn counter-clockwise about their axis") {
    // A quarter turn about +z takes x to y and y to -x; about +y it takes z to x and x to -z.
    checkNear(loadSphere("[{rotate: {axis: [0, 0, 5], degrees: 90}}]").center, {-2, 1, 3});
    checkNear(loadSphere("[{rotate: {axis: [0, 1, 0], degrees: 90}}]").center, {3, 2, -1});
    // A third of a turn about (1, 1, 1) takes x to y, y to z and z to x.
    checkNear(loadSphere("[{rotate: {axis: [1, 1, 1], degrees: 120}}]").center, {3, 1, 2});
}

TEST_CASE("a matrix is read row by row") {
    // x' = 2 y + 5, y' = -2 x + 6, z' = 2 z + 7: a turn, a scale by 2 and a shift.
    const Sphere sphere = loadSphere("[{matrix: [0, 2, 0, 5, -2, 0, 0, 6, 0, 0, 2, 7, 0, 0, 0, 1]}]");
    checkNear(sphere.center, {9, 4, 13});
    CHECK_THAT(sphere.radius, WithinAbs(1, 1e-12));
}

TEST_CASE("metals have the index of their name or a given one, and materials are smooth by default") {
    TemporaryFolder folder;
    const Scene scene =
        loadScene(folder.write("scene.yaml", "hyalite: 1\n"
                                             "lights: [{type: point, position: [0, 1, 0]}]\n"
                                             "materials:\n"
                                             "  a: {type: conductor, metal: silver, roughness: 0.25}\n"
                                             "  b: {type: conductor, eta: 1.5, k: [1, 2, 3]}\n"
                                             "  c: {type: dielectric, roughness: 0.5}\n"
                                             "  d: {type: metallic_roughness}\n"
                                             "  e: {type: metallic_roughness, base_color: [1, 0, 0.5], metallic: 1, "
                                             "roughness: 0.1}\n"
                                             "objects: [{shape: {type: sphere, radius: 1}, material: a}]\n"));
    const MaterialModel silver = scene.materials.at(0).model;
    CHECK(silver.eta == glm::dvec3(0.155, 0.117, 0.138));
    CHECK(silver.k == glm::dvec3(4.828, 3.122, 2.147));
    CHECK(silver.roughness == 0.25);
    const MaterialModel own = scene.materials.at(1).model;
    CHECK(own.eta == glm::dvec3(1.5));
    CHECK(own.k == glm::dvec3(1, 2, 3));
    CHECK(own.roughness == 0);
    CHECK(scene.materials.at(2).model.ior == 1.5);
    CHECK(scene.materials.at(2).model.roughness == 0.5);
    const MaterialModel gray = scene.materials.at(3).model;
    CHECK(gray.color == glm::dvec3(0.8));
    CHECK(gray.metallic == 0);
    CHECK(gray.roughness == 0.5);
    const MaterialModel pink = scene.materials.at(4).model;
    CHECK(pink.color == glm::dvec3(1, 0, 0.5));
    CHECK(pink.metallic == 1);
    CHECK(pink.roughness == 0.1);
}

TEST_CASE("a quad follows any affine map") {
    // Shear x += y, after stretching y by 3: the edge (0, 1, 0) becomes (3, 3, 0).
    const Quad quad = loadQuad(
        "[{scale: [1, 3, 1]}, {matrix: [1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}, {translate: [1, 2, 3]}]");
    checkNear(quad.corner, {1, 2, 3});
    checkNear(quad.edge0, {1, 0, 0});
    checkNear(quad.edge1, {3, 3, 0});
    checkNear(normalOf(quad), {0, 0, 1});
}

TEST_CASE("a mirror image keeps the front of a quad where the mirror puts it") {
    // The front faces +z. Mirroring x leaves it there; mirroring z turns it to -z.
    const Quad across = loadQuad("[{scale: [-1, 1, 1]}]");
    checkNear(normalOf(across), {0, 0, 1});
    checkNear(across.corner + across.edge0 + across.edge1, {-1, 1, 0});
    checkNear(normalOf(loadQuad("[{scale: [1, 1, -1]}]")), {0, 0, -1});
    // A point reflection is a half turn about z and a mirroring of z.
    checkNear(normalOf(loadQuad("[{scale: -1}]")), {0, 0, -1});
}

TEST_CASE("a mirrored sphere is a sphere") {
    const Sphere sphere = loadSphere("[{scale: [-2, 2, 2]}]");
    checkNear(sphere.center, {-2, 4, 6});
    CHECK_THAT(sphere.radius, WithinAbs(1, 1e-12));
}

TEST_CASE("bounds enclose every kind of shape") {
    TemporaryFolder folder;
    folder.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n"); // no face has the last vertex
    const Scene scene = loadScene(folder.write("scene.yaml", R"(hyalite: 1
lights: [{type: point, position: [0, 100, 0]}]
materials: {gray: {type: diffuse}}
objects:
  - {shape: {type: sphere, center: [1, 0, 0], radius: 2}, material: gray}
  - {shape: {type: quad, corner: [0, 0, 0], edges: [[0, -3, 0], [0, 0, 4]]}, material: gray}
  - {shape: {type: mesh, file: triangle.obj}, material: gray, transform: [{scale: 5}]}
)"));
    // Sphere: [-1, 3] x [-2, 2]^2; quad: y to -3, z to 4; triangle: x to 5, y to 5.
    const Bounds bounds = sceneBounds(scene);
    checkNear(bounds.low, {-1, -3, -2});
    checkNear(bounds.high, {5, 5, 4});
    CHECK_THAT(sceneRadius(scene), WithinRel(std::sqrt(36.0 + 64 + 36) / 2, 1e-15));
}

TEST_CASE("objects that name the same file share one mesh and keep their own transforms") {
    TemporaryFolder folder;
    folder.write("models/triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("other.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n");
    const Scene scene = loadScene(folder.write("scene.yaml", R"(hyalite: 1
lights: [{type: point, position: [0, 1, 0]}]
materials: {gray: {type: diffuse}}
objects:
  - {shape: {type: mesh, file: models/triangle.obj}, material: gray}
  - {shape: {type: mesh, file: ./models/../models/triangle.obj}, material: gray, transform: [{translate: [0, 0, 7]}]}
  - {shape: {type: mesh, file: other.obj}, material: gray}
)"));
    REQUIRE(scene.meshes.size() == 2);
    const auto& first = std::get<MeshInstance>(scene.objects.at(0).shape);
    const auto& second = std::get<MeshInstance>(scene.objects.at(1).shape);
    CHECK(first.mesh == 0);
    CHECK(second.mesh == 0);
    CHECK(std::get<MeshInstance>(scene.objects.at(2).shape).mesh == 1);
    CHECK(first.objectToWorld == glm::dmat4(1));
    checkNear(glm::dvec3(second.objectToWorld * glm::dvec4(1, 2, 3, 1)), {1, 2, 10});
}

TEST_CASE("a repetition makes every combination of its steps, after the object's own transform") {
    TemporaryFolder folder;
    const Scene scene = loadScene(folder.write("scene.yaml", R"(
hyalite: 1
materials: {gray: {type: diffuse}}
lights: [{type: point, position: [0, 0, 0]}]
objects:
  - shape: {type: sphere, radius: 1}
    material: gray
    transform: [{translate: [1, 0, 0]}]
    repeat: [{count: 3, transform: [{scale: 2}]}, {count: 2, transform: [{translate: [0, 5, 0]}]}]
)"));
    // Moved by 1, then scaled by 1, 2 and 4 about the origin; then all three again 5 higher
    REQUIRE(scene.objects.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) {
        const double scale = i % 3 == 0 ? 1 : i % 3 == 1 ? 2 : 4;
        const auto& sphere = std::get<Sphere>(scene.objects[i].shape);
        CHECK(sphere.radius == scale);
        checkNear(sphere.center, {scale, i < 3 ? 0 : 5, 0});
    }
}
