// Faces and objects that a scene lists twice.
#include "scene/model/repeated_faces.h"
#include "unit/scene/scene_test_support.h"

#include <catch2/matchers/catch_matchers_string.hpp>

using namespace hyalite;
using namespace hyalite::test;

namespace {

constexpr std::string_view kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

struct Loaded {
    Scene scene;
    std::filesystem::path folder;
};

Loaded load(const std::string& objects, const std::string& mesh = {}, const std::string& file = "mesh.obj") {
    TemporaryFolder folder;
    if (!mesh.empty()) {
        folder.write(file, mesh);
    }
    return {loadScene(folder.write("scene.yaml", "hyalite: 1\nlights: [{type: point, position: [0, 9, 0]}]\n"
                                                 "materials: {a: {type: diffuse}, b: {type: diffuse}, "
                                                 "g: {type: dielectric}}\nobjects:\n" +
                                                     objects)),
            folder.path()};
}

Scene withMesh(const std::string& faces, const std::string& file = "mesh.obj") {
    return load("  - {shape: {type: mesh, file: " + file + "}, material: a}\n",
                (file == "mesh.obj" ? std::string(kSquare) : "") + faces, file)
        .scene;
}

std::string objectAt(const std::string& shape, const std::string& rest = "material: a") {
    return "  - {shape: " + shape + ", " + rest + "}\n";
}

} // namespace

TEST_CASE("a face listed twice is left out at its line, whatever corner it begins with") {
    const Scene scene = withMesh("f 1 2 3\nf 1 3 4\nf 2 3 1\nf 4 1 3\n");
    CHECK(scene.meshes[0].triangles == std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}});
    CHECK(scene.meshes[0].lines == std::vector<std::uint32_t>{5, 6});
    REQUIRE(scene.warnings.size() == 1);
    const Warning& warning = scene.warnings[0];
    CHECK(warning.kind == WarningKind::RepeatedFaces);
    CHECK(warning.where.file == scene.meshes[0].file);
    CHECK(warning.where.line == 7);
    CHECK(warning.what == "this face lists a triangle of line 5 again; 2 repeated triangles are left out");
}

TEST_CASE("corners of equal places are one corner") {
    const Scene scene = withMesh("v 0 0 -0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 6 7 5\n");
    CHECK(scene.meshes[0].triangles.size() == 1);
    CHECK(scene.warnings.size() == 1);
}

TEST_CASE("a polygon listed twice is left out even if it begins elsewhere") {
    const Scene scene = withMesh("f 1 2 3 4\nf 2 3 4 1\nf 1 2 3\n");
    CHECK(scene.meshes[0].triangles.size() == 2); // the triangle of line 7 is half of the square, cut the same way
    REQUIRE(scene.warnings.size() == 1);
    CHECK(scene.warnings[0].where.line == 6);
    CHECK_THAT(scene.warnings[0].what, Catch::Matchers::ContainsSubstring("3 repeated triangles"));
}

TEST_CASE("text of STL files names the line of the facet") {
    const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                              "endloop\nendfacet\n";
    const Scene scene = withMesh("solid s\n" + facet + facet + "endsolid s\n", "mesh.stl");
    CHECK(scene.meshes[0].triangles.size() == 1);
    REQUIRE(scene.warnings.size() == 1);
    CHECK(scene.warnings[0].where.line == 9);
}

TEST_CASE("both sides of a card, and faces that share corners, are kept without a warning") {
    const Scene scene = withMesh("f 1 2 3\nf 3 2 1\nf 1 2 4\nf 1 1 2\nf 1 1 2\n");
    CHECK(scene.meshes[0].triangles.size() == 5);
    CHECK(scene.warnings.empty());
}

TEST_CASE("a lamp whose faces lie back to back is reported") {
    const auto lamp = [](const std::string& faces) {
        return load(objectAt("{type: mesh, file: mesh.obj}", "emission: 1"), std::string(kSquare) + faces).scene;
    };
    const Scene scene = lamp("f 1 2 3\nf 2 1 3\n");
    REQUIRE(scene.warnings.size() == 1);
    CHECK(scene.warnings[0].kind == WarningKind::BackToBack);
    CHECK(scene.warnings[0].where.line == 6);
    CHECK(lamp("f 1 2 3\nf 1 3 4\n").warnings.empty());
}

TEST_CASE("an object listed twice is left out, however the file writes it") {
    const std::vector<std::array<std::string, 2>> pairs{
        {"{type: sphere, center: [0.3, 0.1, 0], radius: 0.2}",
         "{type: sphere, radius: 0.1, transform: [{scale: 2}, {translate: [0.1, 0, 0]}, {translate: [0.2, 0.1, 0]}]}"},
        {"{type: quad, corner: [0, 0, 0], edges: [[1, 0, 0], [0, 2, 0]]}",
         "{type: quad, corner: [1, 2, 0], edges: [[-1, 0, 0], [0, -2, 0]]}"},
        {"{type: quad, corner: [0, 0, 0], edges: [[1, 0, 0], [0, 2, 0]]}",
         "{type: quad, corner: [1, 0, 0], edges: [[0, 2, 0], [-1, 0, 0]]}"},
        {"{type: disk, center: [0, 1, 0], radius: 0.5, normal: [0, 0, 1]}",
         "{type: disk, center: [0, 1, 0], radius: 0.5, normal: [0, 0, 3]}"},
        {"{type: plane, point: [0, 1, 0], normal: [0, 1, 0]}", "{type: plane, point: [5, 1, 7], normal: [0, 2, 0]}"},
        {"{type: torus, major: 1, minor: 0.2}", "{type: torus, major: 1, minor: 0.2, transform: [{scale: 1}]}"},
        {"{type: cylinder, base: [0, 0, 0], top: [0, 1, 0], radius: 0.3}",
         "{type: cylinder, base: [0, 0, 0], top: [0, 1, 0], radius: 0.3}"},
        {"{type: csg, op: union, shapes: [{type: sphere, radius: 0.9}, {type: box, min: [0, 0, 0], max: [1, 1, 1]}]}",
         "{type: csg, op: union, shapes: [{type: sphere, radius: 0.9}, {type: box, min: [0, 0, 0], max: [1, 1, 1]}]}"},
    };
    for (const auto& [first, second] : pairs) {
        INFO(first << " and " << second);
        const Scene scene = load(objectAt(first) + objectAt(second)).scene;
        CHECK(scene.objects.size() == 1);
        REQUIRE(scene.warnings.size() == 1);
        CHECK(scene.warnings[0].kind == WarningKind::RepeatedObject);
        CHECK(scene.warnings[0].where.line == 6);
        CHECK(scene.warnings[0].where.column == 5);
        CHECK_THAT(scene.warnings[0].what, Catch::Matchers::ContainsSubstring("line 5 column 5 and is left out"));
    }
}

TEST_CASE("copies that come round to the first place are left out") {
    const Scene scene = load(objectAt("{type: sphere, center: [1, 0, 0], radius: 0.1}",
                                      "material: a, repeat: [{count: 8, transform: [{rotate: {axis: [0, 1, 0], "
                                      "degrees: 90}}]}]"))
                            .scene;
    CHECK(scene.objects.size() == 4);
    CHECK(scene.warnings.size() == 1);
}

TEST_CASE("objects beside each other, and the sides of a card, are different objects") {
    const std::vector<std::array<std::string, 2>> pairs{
        {"{type: sphere, center: [1000, 0, 0], radius: 1}", "{type: sphere, center: [1000.000001, 0, 0], radius: 1}"},
        {"{type: sphere, radius: 1}", "{type: sphere, radius: 1.00000001}"},
        {"{type: quad, corner: [0, 0, 0], edges: [[1, 0, 0], [0, 2, 0]]}",
         "{type: quad, corner: [0, 0, 0], edges: [[0, 2, 0], [1, 0, 0]]}"}, // its back
        {"{type: disk, radius: 1, normal: [0, 0, 1]}", "{type: disk, radius: 1, normal: [0, 0, -1]}"},
        {"{type: box, min: [0, 0, 0], max: [1, 1, 1]}", "{type: box, min: [0, 0, 0], max: [1, 1, 2]}"},
    };
    for (const auto& [first, second] : pairs) {
        INFO(first << " and " << second);
        const Scene scene = load(objectAt(first) + objectAt(second)).scene;
        CHECK(scene.objects.size() == 2);
        CHECK(scene.warnings.empty());
    }
}

TEST_CASE("two objects in one place of different material are reported and kept") {
    const Scene scene =
        load(objectAt("{type: sphere, radius: 1}") + objectAt("{type: sphere, radius: 1}", "material: b")).scene;
    CHECK(scene.objects.size() == 2);
    REQUIRE(scene.warnings.size() == 1);
    CHECK_THAT(scene.warnings[0].what, Catch::Matchers::ContainsSubstring("rounding decides"));
}

TEST_CASE("lamps in one place: equal ones count once, different ones are refused, back to back is reported") {
    const std::string quad = "{type: quad, corner: [0, 0, 0], edges: [[1, 0, 0], [0, 2, 0]]}";
    const std::string back = "{type: quad, corner: [0, 0, 0], edges: [[0, 2, 0], [1, 0, 0]]}";
    CHECK(load(objectAt(quad, "emission: 3") + objectAt(quad, "emission: 3")).scene.objects.size() == 1);
    const auto error = errorOf([&] { return load(objectAt(quad, "emission: 3") + objectAt(quad, "emission: 2")); });
    REQUIRE(error);
    CHECK(error->code() == ExitCode::BadInput);
    CHECK(error->where().line == 6);
    const Scene two = load(objectAt(quad, "emission: 3") + objectAt(back, "emission: 3")).scene;
    CHECK(two.objects.size() == 2);
    REQUIRE(two.warnings.size() == 1);
    CHECK(two.warnings[0].kind == WarningKind::BackToBack);
}

TEST_CASE("a scene that accepts a kind of warning is not warned of it") {
    const std::string sphere = objectAt("{type: sphere, radius: 1}");
    CHECK(load(sphere + sphere + "accept: [repeated-object]\n").scene.warnings.empty());
    CHECK(load(sphere + sphere + "accept: [repeated-faces]\n").scene.warnings.size() == 1);
}
