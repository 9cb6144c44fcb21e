// Constructive solid geometry in the scene file: the program and leaves of a tree, their transforms, materials and
// bounds, and every mistake with its place.
#include "unit/scene/bad_scene.h"

#include "scene/model/bounds.h"

#include <cmath>
#include <glm/glm.hpp>

using namespace hyalite;
using namespace hyalite::test;
using glm::dvec3;

namespace {

constexpr std::size_t kGray = 0; // the object's, then in the file's order
constexpr std::size_t kRed = 1;
constexpr std::size_t kGreen = 2;
constexpr std::size_t kBlue = 3;

const std::string kBall = "{type: sphere, radius: 1}";

// The program as text: a letter for each leaf, | for union, & for intersection, - for difference.
std::string programText(const Scene& scene, std::size_t object = 0) {
    std::string text;
    char leaf = 'A';
    for (const CsgStep step : std::get<Csg>(scene.objects.at(object).shape).program) {
        switch (step) {
        case CsgStep::Leaf:
            text += leaf++;
            break;
        case CsgStep::Union:
            text += '|';
            break;
        case CsgStep::Intersection:
            text += '&';
            break;
        case CsgStep::Difference:
            text += '-';
            break;
        }
    }
    return text;
}

std::vector<std::optional<std::size_t>> materials(const Scene& scene) {
    std::vector<std::optional<std::size_t>> result;
    for (const Object& leaf : scene.csgLeaves) {
        result.push_back(leaf.material);
    }
    return result;
}

// `count` shapes, each list of two holding one ball and the rest.
std::string nested(int count) {
    std::string text = "{type: sphere, radius: 1, transform: [{rotate: {axis: [0, 1, 0], degrees: 1}}]}";
    for (int i = 1; i < count; ++i) {
        std::string around = "{type: csg, op: union, shapes: [" + kBall;
        around += ", ";
        around += text;
        around += "]}";
        text = std::move(around);
    }
    return text;
}

std::string listed(int count) {
    std::string text = "{type: csg, op: union, shapes: [";
    for (int i = 0; i < count; ++i) {
        text += kBall + ", ";
    }
    return text + "]}";
}

const std::string kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                 "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

} // namespace

TEST_CASE("a csg becomes a postfix program over its leaves in the file's order") {
    CHECK(programText(loadWithShape("{type: csg, op: union, left: " + kBall + ", right: " + kBall + "}")) == "AB|");
    // Left stands before right, whichever is written first.
    const Scene swapped =
        loadWithShape("{type: csg, op: difference, right: {type: sphere, radius: 2}, left: " + kBall + "}");
    CHECK(programText(swapped) == "AB-");
    CHECK(std::get<Sphere>(swapped.csgLeaves.at(0).shape).radius == 1);
    // A list is taken from the left: (A - B) - C.
    CHECK(programText(loadWithShape("{type: csg, op: difference, shapes: [" + kBall + ", " + kBall + ", " + kBall +
                                    "]}")) == "AB-C-");
    // A - (B & C)
    CHECK(programText(loadWithShape("{type: csg, op: difference, left: " + kBall +
                                    ", right: {type: csg, op: intersection, shapes: [" + kBall + ", " + kBall +
                                    "]}}")) == "ABC&-");
}

TEST_CASE("the leaves of several objects follow one another") {
    TemporaryFolder folder;
    const std::string csg = "{type: csg, op: union, shapes: [" + kBall + ", " + kBall + "]}";
    const Scene scene = loadScene(folder.write(
        "scene.yaml", "hyalite: 1\n"
                      "lights: [{type: point, position: [0, 1, 0]}]\n"
                      "materials: {gray: {type: diffuse}}\n"
                      "objects:\n"
                      "  - {material: gray, shape: " +
                          csg + "}\n  - {material: gray, shape: " + kBall +
                          "}\n  - {material: gray, transform: [{translate: [9, 0, 0]}], shape: " + csg + "}\n"));
    CHECK(scene.csgLeaves.size() == 4);
    CHECK(std::get<Csg>(scene.objects.at(0).shape).firstLeaf == 0);
    CHECK(std::get<Csg>(scene.objects.at(2).shape).firstLeaf == 2);
    // Each leaf knows its place in the file: "  - {material: gray, shape: {type: csg, op: union, shapes: [" has 60
    // characters.
    CHECK(scene.csgLeaves.at(0).where.line == 5);
    CHECK(scene.csgLeaves.at(0).where.column == 61);
    CHECK(scene.csgLeaves.at(3).where.line == 7);
}

TEST_CASE("a leaf is transformed by itself, then by each csg around it, then by the object") {
    // The centre (0, 0, 0) is moved to (1, 0, 0), doubled to (2, 0, 0), turned about z to (0, 2, 0).
    const Scene scene = loadWithShape("{type: csg, op: union, left: {type: csg, op: union, transform: [{scale: 2}], "
                                      "left: {type: sphere, radius: 1, transform: [{translate: [1, 0, 0]}]}, right: " +
                                          kBall + "}, right: " + kBall + "}",
                                      "[{rotate: {axis: [0, 0, 1], degrees: 90}}]");
    const auto sphere = [&](std::size_t leaf) { return std::get<Sphere>(scene.csgLeaves.at(leaf).shape); };
    CHECK(glm::length(sphere(0).center - dvec3(0, 2, 0)) < 1e-12);
    CHECK(std::abs(sphere(0).radius - 2) < 1e-12);
    CHECK(std::abs(sphere(1).radius - 2) < 1e-12);
    CHECK(std::abs(sphere(2).radius - 1) < 1e-12);
}

TEST_CASE("a face's material is the shape's own, or the nearest csg's, or the object's") {
    const Scene scene = loadWithShape("{type: csg, op: difference, left: {type: csg, op: union, material: green, "
                                      "left: {type: sphere, radius: 1, material: red}, right: " +
                                      kBall + "}, right: " + kBall + "}");
    CHECK(materials(scene) == std::vector<std::optional<std::size_t>>{kRed, kGreen, kGray});
}

TEST_CASE("cut_material applies to all faces cut by the right operands, the outermost taking precedence") {
    // In a list all but the first shape cut; their own materials do not matter.
    const Scene list = loadWithShape("{type: csg, op: difference, cut_material: blue, shapes: "
                                     "[{type: sphere, radius: 1, material: red}, " +
                                     kBall + ", {type: sphere, radius: 1, material: green}]}");
    CHECK(materials(list) == std::vector<std::optional<std::size_t>>{kRed, kBlue, kBlue});
    // Within a right operand everything cuts, also what a difference in it cuts itself; in the left one its own counts.
    const std::string inner = "{type: csg, op: difference, cut_material: green, left: {type: sphere, radius: 1, "
                              "material: red}, right: " +
                              kBall + "}";
    const Scene outer =
        loadWithShape("{type: csg, op: difference, cut_material: blue, left: " + inner + ", right: " + inner + "}");
    CHECK(materials(outer) == std::vector<std::optional<std::size_t>>{kRed, kGreen, kBlue, kBlue});
}

TEST_CASE("an object whose csg shapes all have a material needs none") {
    TemporaryFolder folder;
    const Scene scene = loadScene(folder.write(
        "scene.yaml", withObject("{shape: {type: csg, op: union, left: {type: sphere, radius: 1, material: gray}, "
                                 "right: {type: sphere, radius: 2, material: gray}}}")));
    CHECK_FALSE(scene.objects.at(0).material.has_value());
    CHECK(materials(scene) == std::vector<std::optional<std::size_t>>{kGray, kGray});
}

TEST_CASE("closed meshes are solids") {
    TemporaryFolder folder;
    folder.write("mesh.obj", kTetrahedron);
    const Scene scene =
        loadScene(folder.write("scene.yaml", withObject("{material: gray, shape: {type: csg, op: difference, left: "
                                                        "{type: mesh, file: mesh.obj}, right: {type: mesh, file: "
                                                        "mesh.obj, transform: [{scale: 0.5}]}}}")));
    CHECK(scene.meshes.size() == 1);
    CHECK(std::get<MeshInstance>(scene.csgLeaves.at(1).shape).objectToWorld[0][0] == 0.5);
}

TEST_CASE("a tree may have 32 shapes, however they are nested") {
    for (const std::string& text : {listed(32), nested(32)}) {
        const Scene scene = loadWithShape(text);
        CHECK(scene.csgLeaves.size() == 32);
        CHECK(std::get<Csg>(scene.objects.at(0).shape).program.size() == 63); // 31 operations
    }
}

TEST_CASE("the bounds of a csg are no larger than its operation allows") {
    const auto bounds = [](const std::string& op, const std::string& right) {
        const Scene scene = loadWithShape("{type: csg, op: " + op +
                                          ", left: {type: box, min: [0, 0, 0], max: [2, 2, 2]}, right: " + right + "}");
        return worldBounds(scene, scene.objects.at(0));
    };
    const std::string box = "{type: box, min: [1, -1, 0], max: [3, 1, 4]}";
    CHECK(bounds("union", box).low == dvec3(0, -1, 0));
    CHECK(bounds("union", box).high == dvec3(3, 2, 4));
    CHECK(bounds("intersection", box).low == dvec3(1, 0, 0));
    CHECK(bounds("intersection", box).high == dvec3(2, 1, 2));
    CHECK(bounds("difference", box).low == dvec3(0, 0, 0));
    CHECK(bounds("difference", box).high == dvec3(2, 2, 2));
    // A half-space across an axis ends on one side; a tilted one has no bounds of its own.
    CHECK(bounds("intersection", "{type: plane, point: [0, 1.5, 0], normal: [0, 1, 0]}").high == dvec3(2, 1.5, 2));
    CHECK(bounds("intersection", "{type: plane, point: [0, 1.5, 0], normal: [0, -1, 0]}").low == dvec3(0, 1.5, 0));
    CHECK(bounds("intersection", "{type: plane, point: [0, 1, 0], normal: [1, 1, 0]}").high == dvec3(2, 2, 2));
    CHECK_FALSE(isFinite(bounds("union", "{type: plane, point: [0, 1, 0], normal: [0, 1, 0]}")));
}

TEST_CASE("mistakes in a csg are reported at the key") {
    const auto csg = [](const std::string& shape) { return withObject("{material: gray, shape: " + shape + "}"); };
    const std::string two = "left: " + kBall + ", right: " + kBall;
    checkAll({
        {csg("${type: csg, " + two + "}"), "missing key 'op' in 'shape'"},
        {csg("{type: csg, op: $differnce, " + two + "}"), "unknown operation 'differnce'",
         "did you mean 'difference'?"},
        {csg("${type: csg, op: union}"), "a csg needs operands", "'left' and 'right', or a list of 'shapes'"},
        {csg("${type: csg, op: union, left: " + kBall + "}"), "missing key 'right' in 'shape'"},
        {csg("${type: csg, op: union, right: " + kBall + "}"), "missing key 'left' in 'shape'"},
        {csg("{type: csg, op: union, shapes: [" + kBall + ", " + kBall + "], left: $" + kBall + "}"), "not both"},
        {csg("{type: csg, op: union, shapes: $[]}"), "at least 2 'shapes', found 0"},
        {csg("{type: csg, op: union, shapes: $[" + kBall + "]}"), "at least 2 'shapes', found 1"},
        {csg("{type: csg, op: union, shapes: $" + kBall + "}"), "'shapes' must be a list, found a map"},
        {csg("{type: csg, op: union, $lift: 1, " + two + "}"), "unknown key 'lift'", "did you mean 'left'?"},
        {csg("{type: csg, op: union, left: $7, right: " + kBall + "}"), "'left' must be a map"},
        {csg("{type: csg, op: union, left: " + kBall + ", right: {type: sphere, $raduis: 1}}"), "unknown key 'raduis'",
         "did you mean 'radius'?"},
        {csg("{type: csg, op: union, left: " + kBall + ", right: {type: $shpere}}"), "unknown shape 'shpere'"},
        {csg("{type: csg, op: union, shapes: [" + kBall + ", {type: sphere, radius: 1, material: $grey}]}"),
         "unknown material 'grey'", "did you mean 'gray'?"},
        {csg("{type: csg, op: difference, cut_material: $grey, " + two + "}"), "unknown material 'grey'"},
        {csg("{type: csg, op: union, cut_material: $gray, " + two + "}"), "only a difference has cut faces"},
        {csg("{type: csg, op: intersection, cut_material: $gray, " + two + "}"), "only a difference has cut faces"},
        {withObject("{shape: {type: csg, op: union, left: {type: sphere, radius: 1, material: gray}, right: $" + kBall +
                    "}}"),
         "this shape has no material", "to it, to an enclosing csg or to the object"},
        {withObject("{material: gray, emission: $1, shape: {type: csg, op: union, " + two + "}}"), "only quads"},
        {csg("${type: csg, op: intersection, left: " + kBall +
             ", right: {type: sphere, center: [3, 0, 0], radius: 1}}"),
         "this intersection is empty"},
    });
}

TEST_CASE("more shapes than a csg can have are reported at the csg that has them") {
    const auto csg = [](const std::string& shape) { return withObject("{material: gray, shape: " + shape + "}"); };
    checkAll({
        {csg(std::string("$").append(listed(33))), "more than 32 shapes"},
        {csg(std::string("$").append(nested(33))), "more than 32 shapes"},
        {csg("${type: csg, op: union, left: " + listed(16) + ", right: " + listed(17) + "}"), "more than 32 shapes"},
        // The inner one is at fault, not the one around it.
        {csg("{type: csg, op: union, left: $" + listed(33) + ", right: " + kBall + "}"), "more than 32 shapes"},
    });
}

TEST_CASE("transforms that are singular only in combination are reported at the innermost") {
    const auto csg = [](const std::string& outer, const std::string& inner) {
        return withObject("{material: gray, transform: " + outer + ", shape: {type: csg, op: union, left: " + kBall +
                          ", right: {type: sphere, radius: 1, transform: " + inner + "}}}");
    };
    checkAll({
        {csg("[{scale: 1e-6}]", "$[{scale: 1e-6}]"), "combined with the enclosing transforms, this one is singular"},
        {csg("[]", "[{scale: $[1, 0, 1]}]"), "this transform is singular"},
        {csg("[{scale: 1e8}]", "$[{translate: [100, 0, 0]}]"), "move the object farther than 1e+09 m"},
    });
}

TEST_CASE("shapes without an inside are reported where a csg would need one") {
    const auto with = [](const std::string& shape) {
        return withObject("{material: gray, shape: {type: csg, op: difference, left: " + kBall + ", right: $" + shape +
                          "}}");
    };
    const std::string ends = "base: [0, 0, 0], top: [0, 1, 0], radius: 1";
    checkAll({
        {with("{type: quad, corner: [0, 0, 0], edges: [[1, 0, 0], [0, 1, 0]]}"), "a quad has no inside", "a plane"},
        {with("{type: disk, normal: [0, 1, 0], radius: 1}"), "a disk has no inside", "a flat cylinder"},
        {with("{type: cylinder, open: true, " + ends + "}"), "this shape is open", "caps"},
        {with("{type: cone, open: true, " + ends + "}"), "this shape is open", "caps"},
        {with("{type: paraboloid, radii: [1, 1, 1], clip: {max: [null, 1, null]}, caps: false}"), "this shape is open"},
        {with("{type: quadric, coefficients: [1, 0, 0, 0, 1, 0, 0, 1, 0, -1], clip: {max: [null, 0, null]}, "
              "caps: false}"),
         "this shape is open"},
        {with("{type: teapot}"), "this mesh is open"},
        {.marked = with("{type: mesh, file: mesh.obj}"),
         .what = "this mesh is open at the edge from (",
         .hint = "every edge",
         .mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n"},
        {.marked = with("{type: mesh, file: mesh.obj}"),
         .what = "this mesh encloses nothing", // a triangle and its back
         .mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n"},
        {.marked = with("{type: mesh, file: mesh.obj}"),
         .what = "this mesh is inside out",
         .hint = "order of their corners",
         .mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"},
    });
}
