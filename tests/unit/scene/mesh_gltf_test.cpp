// glTF import: the same pyramid in every encoding, attributes, nodes, materials, and scenes that show such files.
#include "unit/scene/mesh_gltf_support.h"

#include "scene/import/base64.h"
#include "scene/import/mesh_import.h"
#include "scene/model/mesh_topology.h"

#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinRel;
using namespace hyalite;
using namespace hyalite::test;

namespace {

void checkNear(const glm::dvec3& actual, const glm::dvec3& expected) {
    INFO(actual.x << ' ' << actual.y << ' ' << actual.z);
    CHECK(glm::length(actual - expected) < 1e-12);
}

glm::dvec3 placed(const ImportedPart& part, const glm::dvec3& point) {
    return part.toFile * glm::dvec4(point, 1);
}

std::string sceneWith(const std::string& objects) {
    return "hyalite: 1\nmaterials: {mine: {type: dielectric}}\nlights: [{type: point, position: [0, 9, "
           "0]}]\nobjects:\n" +
           objects;
}

} // namespace

TEST_CASE("base64 is decoded, padded or not, and nothing else is") {
    // RFC 4648, section 10.
    CHECK(decodeBase64("") == "");
    CHECK(decodeBase64("Zg==") == "f");
    CHECK(decodeBase64("Zm8=") == "fo");
    CHECK(decodeBase64("Zm9v") == "foo");
    CHECK(decodeBase64("Zm9vYg") == "foob");
    CHECK(decodeBase64("Zm9vYmFy") == "foobar");
    CHECK(decodeBase64("+/+/") == "\xfb\xff\xbf");
    for (const std::string_view wrong : {"Z", "Zm9vY", "Zm9*", "Zm 9", "Zg=a", "====", "Zm9v="}) {
        INFO(wrong);
        CHECK_FALSE(decodeBase64(wrong));
    }
}

TEST_CASE("a pyramid is the same mesh from glTF with every kind of indices, within the text and as binary file") {
    checkPyramid(onlyMesh(pyramidGltf().text()));
    checkPyramid(onlyMesh(pyramidGltf().binary()));

    const std::vector<std::uint32_t> indices = pyramidIndices();
    Gltf shorts;
    const std::size_t positions = shorts.addPositions(kCorners);
    shorts.addPrimitive(positions)["indices"] =
        shorts.addIndices(std::vector<std::uint16_t>(indices.begin(), indices.end()), kUnsignedShort);
    checkPyramid(onlyMesh(shorts.text()));

    Gltf bytes; // positions behind 18 bytes of indices: not aligned, which the format forbids and many files do
    const std::size_t first =
        bytes.addIndices(std::vector<std::uint8_t>(indices.begin(), indices.end()), kUnsignedByte);
    const std::size_t behind = bytes.addPositions(kCorners);
    bytes.addPrimitive(behind)["indices"] = first;
    checkPyramid(onlyMesh(bytes.text()));
}

TEST_CASE("glTF buffers may be files beside it, their names written with percent signs") {
    TemporaryFolder folder;
    Gltf gltf = pyramidGltf();
    gltf.document["buffers"] = {{{"uri", "data/my%20corners.bin"}, {"byteLength", gltf.buffer.size()}}};
    folder.write("models/data/my corners.bin", gltf.buffer);
    checkPyramid(importMesh(folder.write("models/pyramid.GLTF", gltf.text()), {}));
    checkPyramid(importMesh(folder.write("models/pyramid.glb", pyramidGltf().binary()), {}));
}

TEST_CASE("a glTF primitive without indices has its vertices in order") {
    std::vector<glm::vec3> corners;
    for (const std::uint32_t index : pyramidIndices()) {
        corners.push_back(kCorners[index]);
    }
    Gltf gltf;
    gltf.addPrimitive(gltf.addPositions(corners));
    const Mesh mesh = onlyMesh(gltf.text());
    CHECK(mesh.positions == corners);
    CHECK_FALSE(findOpenEdge(mesh));
}

TEST_CASE("glTF strips and fans become the triangles that the format describes") {
    const std::vector<glm::vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
    Gltf strip;
    strip.addPrimitive(strip.addPositions(corners))["mode"] = 5;
    // Triangle i is (i, i + 1 + i mod 2, i + 2 - i mod 2).
    CHECK(onlyMesh(strip.text()).triangles == std::vector<glm::uvec3>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}});

    Gltf sewn; // two triangles, joined by repeated corners as strips are
    const std::size_t positions = sewn.addPositions(corners);
    json& primitive = sewn.addPrimitive(positions);
    primitive["mode"] = 5;
    const std::size_t indices = sewn.addIndices(std::vector<std::uint16_t>{0, 1, 2, 2, 2, 3, 4}, kUnsignedShort);
    sewn.document["meshes"][0]["primitives"][0]["indices"] = indices;
    CHECK(onlyMesh(sewn.text()).triangles == std::vector<glm::uvec3>{{0, 1, 2}, {2, 3, 4}});

    Gltf fan;
    fan.addPrimitive(fan.addPositions(corners))["mode"] = 6;
    // Triangle i is (i + 1, i + 2, 0).
    CHECK(onlyMesh(fan.text()).triangles == std::vector<glm::uvec3>{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}});
}

TEST_CASE("glTF attributes may share a view with a stride, and be normalised integers") {
    // Position as float, normal as normalized byte, texture coordinate as normalized unsigned short: 12 + 4 + 4 bytes.
    const std::vector<glm::vec3> corners{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
    std::string bytes;
    for (const glm::vec3& corner : corners) {
        bytes += bytesOf(std::vector<glm::vec3>{corner});
        bytes += bytesOf(std::vector<std::int8_t>{-128, 0, 0, 99});
        bytes += bytesOf(std::vector<std::uint16_t>{0, 65535});
    }
    Gltf gltf;
    const std::size_t view = gltf.addView(bytes, 20);
    const auto accessor = [&](const char* type, int component, int offset) {
        return gltf.addAccessor({{"bufferView", view},
                                 {"byteOffset", offset},
                                 {"type", type},
                                 {"componentType", component},
                                 {"normalized", component != kFloat},
                                 {"count", 3}});
    };
    const std::size_t position = accessor("VEC3", kFloat, 0);
    const std::size_t normal = accessor("VEC3", kByte, 12);
    const std::size_t uv = accessor("VEC2", kUnsignedShort, 16);
    json& attributes = gltf.addPrimitive(position)["attributes"];
    attributes["NORMAL"] = normal;
    attributes["TEXCOORD_0"] = uv;
    const Mesh mesh = onlyMesh(gltf.text());
    CHECK(mesh.positions == corners);
    CHECK(mesh.normals == std::vector<glm::vec3>(3, {-1, 0, 0})); // max(-128 / 127, -1)
    CHECK(mesh.uvs == std::vector<glm::vec2>(3, {0, 0}));         // (0, 1): the format's v points downwards
}

TEST_CASE("glTF positions may be integers that are not normalised") {
    Gltf gltf;
    const std::size_t accessor =
        gltf.add(bytesOf(std::vector<std::int16_t>{0, 0, 0, 300, 0, 0, 0, -300, 7}), "VEC3", kShort, 3);
    gltf.addPrimitive(accessor);
    CHECK(onlyMesh(gltf.text()).positions == std::vector<glm::vec3>{{0, 0, 0}, {300, 0, 0}, {0, -300, 7}});
}

TEST_CASE("sparse glTF accessors replace elements of a view, or of zeros") {
    Gltf gltf = pyramidGltf();
    const std::size_t indices = gltf.addView(bytesOf(std::vector<std::uint8_t>{1, 4}));
    const std::size_t values = gltf.addView(bytesOf(std::vector<glm::vec3>{{9, 8, 7}, {6, 5, 4}}));
    gltf.document["accessors"][0]["sparse"] = {{"count", 2},
                                               {"indices", {{"bufferView", indices}, {"componentType", kUnsignedByte}}},
                                               {"values", {{"bufferView", values}}}};
    std::vector<glm::vec3> expected = kCorners;
    expected[1] = {9, 8, 7};
    expected[4] = {6, 5, 4};
    CHECK(onlyMesh(gltf.text()).positions == expected);

    gltf.document["accessors"][0].erase("bufferView");
    expected = {{0, 0, 0}, {9, 8, 7}, {0, 0, 0}, {0, 0, 0}, {6, 5, 4}};
    CHECK(onlyMesh(gltf.text()).positions == expected);
}

TEST_CASE("vertices that no triangle uses are left out") {
    Gltf gltf;
    const std::size_t positions = gltf.addPositions({{9, 9, 9}, {0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}});
    const std::size_t indices = gltf.addIndices(std::vector<std::uint8_t>{4, 1, 3}, kUnsignedByte);
    gltf.addPrimitive(positions)["indices"] = indices;
    const Mesh mesh = onlyMesh(gltf.text());
    CHECK(mesh.positions == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(mesh.triangles == std::vector<glm::uvec3>{{2, 0, 1}});
}

TEST_CASE("glTF nodes place meshes by matrices, or by scale, rotation and translation, each under its parents") {
    Gltf gltf = pyramidGltf();
    const double half = std::sqrt(0.5); // a quarter turn about z takes x to y
    gltf.document["nodes"] =
        json::array({{{"children", {1, 2}}, {"translation", {10, 0, 0}}},
                     {{"mesh", 0}, {"scale", {2, 3, 4}}, {"rotation", {0, 0, half, half}}, {"translation", {0, 0, 1}}},
                     {{"mesh", 0}, {"matrix", {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}},
                     {{"mesh", 0}}});
    gltf.document["scenes"] = {{{"nodes", {3}}}, {{"nodes", {0}}}};
    gltf.document["scene"] = 1;
    const ImportedFile file = parse(gltf.text());
    CHECK(file.meshes.size() == 1); // shared
    REQUIRE(file.parts.size() == 2);
    // (1, 1, 1) scaled (2, 3, 4), turned (-3, 2, 4), moved (-3, 2, 5), moved by the parent (7, 2, 5).
    checkNear(placed(file.parts[0], {1, 1, 1}), {7, 2, 5});
    // The matrix, column by column, swaps x and y and moves by (5, 6, 7): (1, 2, 3) to (2, 1, 3) to (17, 7, 10).
    checkNear(placed(file.parts[1], {1, 2, 3}), {17, 7, 10});
    CHECK(file.parts[1].name == "nodes[2], meshes[0].primitives[0]");

    gltf.document.erase("scene");
    CHECK(parse(gltf.text()).parts.size() == 1); // the first scene
    gltf.document.erase("scenes");
    CHECK(parse(gltf.text()).parts.size() == 3); // all trees: those of nodes 0 and 3
}

TEST_CASE("glTF materials are read, and primitives with the same data share a mesh") {
    Gltf gltf = pyramidGltf();
    gltf.document["materials"] =
        json::array({{{"name", "gold"},
                      {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0.8, 0.3, 1}}, {"roughnessFactor", 0.25}}}},
                     {{"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 0.5}}, {"metallicFactor", 0.4}}}}});
    json& primitives = gltf.document["meshes"][0]["primitives"];
    const json first = primitives[0];
    primitives = json::array({first, first, first});
    primitives[0]["material"] = 0;
    primitives[1]["material"] = 1;
    primitives[2]["mode"] = 1; // lines: no surface
    const ImportedFile file = parse(gltf.text());
    REQUIRE(file.parts.size() == 2);
    CHECK(file.parts[0].mesh == file.parts[1].mesh);
    REQUIRE(file.materials.size() == 2);
    const ImportedMaterial& gold = file.materials[file.parts[0].material.value()];
    CHECK(gold.name == "gold");
    CHECK(gold.baseColor == glm::dvec3(1, 0.8, 0.3));
    CHECK(gold.metallic == 1); // the format's default
    CHECK(gold.roughness == 0.25);
    const ImportedMaterial& paint = file.materials[file.parts[1].material.value()];
    CHECK(paint.metallic == 0.4);
    CHECK(paint.roughness == 1);

    const MaterialModel model = sceneModel(gold);
    CHECK(model.color == gold.baseColor);
    CHECK(model.metallic == 1);
    CHECK(model.roughness == 0.25);
}

TEST_CASE("the parts of a glTF file merge into one mesh whose fronts and normals follow their transforms") {
    Gltf gltf = pyramidGltf();
    // A second primitive with normals; and the whole once mirrored in x.
    const std::size_t normals = gltf.addPositions(std::vector<glm::vec3>(5, {0, 0, 3}));
    json& primitives = gltf.document["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives[1]["attributes"]["NORMAL"] = normals;
    gltf.document["nodes"] = json::array({{{"mesh", 0}, {"scale", {-2, 1, 1}}, {"translation", {0, 5, 0}}}});
    const Mesh mesh = mergeParts(parse(gltf.text()));
    CHECK(mesh.triangles.size() == 12);
    REQUIRE(mesh.normals.size() == mesh.positions.size());
    CHECK_FALSE(findOpenEdge(mesh)); // both copies are closed
    // Base 1, height 2: a volume of 2/3, twice as large by the scale, for each copy.
    CHECK_THAT(signedVolume(mesh), WithinRel(2 * 2 * 2.0 / 3, 1e-6));
    for (std::size_t i = 0; i < 6; ++i) { // the copy without normals has those of its faces
        const glm::uvec3 t = mesh.triangles[i];
        const glm::vec3 face =
            glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
        CHECK(glm::length(glm::normalize(face) - mesh.normals[t.x]) < 1e-6F);
    }
    for (std::size_t i = 6; i < 12; ++i) {
        CHECK(mesh.normals[mesh.triangles[i].x] == glm::vec3(0, 0, 1));
    }
}

TEST_CASE("a part without volume is an error of a merged glTF file, with its place") {
    Gltf gltf = pyramidGltf();
    const std::size_t normals = gltf.addPositions(std::vector<glm::vec3>(5, {0, 0, 3}));
    gltf.document["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
    for (const json& scale : {json{0, 0, 0}, json{1, 0, 1}, json{1e-300, 1, 1}}) {
        // The second node's scale is its child's, too
        gltf.document["scenes"][0]["nodes"] = {0, 1};
        gltf.document["nodes"] = {{{"mesh", 0}}, {{"scale", scale}, {"children", {2}}}, {{"mesh", 0}}};
        const auto error = errorOf([&] { static_cast<void>(mergeParts(parse(gltf.text()))); });
        REQUIRE(error);
        CHECK(error->code() == ExitCode::BadInput);
        CHECK(error->message() ==
              "nodes[2], meshes[0].primitives[0]: the transform of this part is singular: it has no inverse");
        CHECK_FALSE(error->where().file.empty());
    }
}

TEST_CASE("a scene shows the parts of a glTF file with its materials, or with the object's own") {
    // Two parts in one place: with their own materials both are shown, with the object's own the second repeats the
    // first
    TemporaryFolder folder;
    Gltf gltf = pyramidGltf();
    gltf.document["materials"] = {{{"pbrMetallicRoughness", {{"metallicFactor", 0}}}}, json::object()};
    json& primitives = gltf.document["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives[0]["material"] = 1;
    primitives[1]["material"] = 0;
    gltf.document["nodes"] = json::array({{{"mesh", 0}, {"translation", {1, 0, 0}}}});
    folder.write("two.glb", gltf.binary());
    const std::string shape = "  - {shape: {type: mesh, file: two.glb}, transform: [{scale: 2}]";
    const Scene scene = loadScene(folder.write("scene.yaml", sceneWith(shape + ", material: mine}\n" + shape + "}\n")));

    CHECK(scene.meshes.size() == 1);
    REQUIRE(scene.objects.size() == 3);
    REQUIRE(scene.materials.size() == 3);
    CHECK(scene.objects[0].material == 0U);
    for (const std::size_t i : {1U, 2U}) {
        const MaterialModel& model = scene.materials.at(scene.objects[i].material.value()).model;
        CHECK(model.color == glm::dvec3(1));
        CHECK(model.metallic == (i == 1 ? 1 : 0)); // 1 where the file does not say
        CHECK(model.roughness == 1);
    }
    for (const Object& object : scene.objects) {
        // Moved by the node, then scaled by the object: (0, 2, 0) to (1, 2, 0) to (2, 4, 0).
        const auto& instance = std::get<MeshInstance>(object.shape);
        checkNear(instance.objectToWorld * glm::dvec4(0, 2, 0, 1), {2, 4, 0});
    }
    CHECK(scene.objects[0].where.line == 5);
    CHECK(scene.objects[2].where.line == 6);
}

TEST_CASE("in a csg a glTF file is one solid") {
    TemporaryFolder folder;
    Gltf gltf = pyramidGltf();
    gltf.document["nodes"] = json::array({{{"mesh", 0}}, {{"mesh", 0}, {"translation", {3, 0, 0}}}});
    gltf.document["scenes"] = {{{"nodes", {0, 1}}}};
    folder.write("two.gltf", gltf.text());
    const Scene scene = loadScene(
        folder.write("scene.yaml",
                     sceneWith("  - {shape: {type: csg, op: difference, left: {type: sphere, radius: 1}, right: {type: "
                               "mesh, file: two.gltf}}, material: mine}\n")));
    REQUIRE(scene.csgLeaves.size() == 2);
    CHECK(scene.objects.size() == 1);
    CHECK(scene.meshes.at(std::get<MeshInstance>(scene.csgLeaves[1].shape).mesh).triangles.size() == 12);
}

TEST_CASE("a part of a glTF file without material or inverse is an error of the object that shows it") {
    TemporaryFolder folder;
    Gltf gltf = pyramidGltf();
    const std::string object = "  - {shape: {type: mesh, file: one.gltf}";
    folder.write("one.gltf", gltf.text());
    const auto bare = errorOf([&] { return loadScene(folder.write("scene.yaml", sceneWith(object + "}\n"))); });
    REQUIRE(bare);
    CHECK(bare->where().line == 5);
    CHECK(bare->where().column == 32); // of the file's name
    CHECK_THAT(bare->what(), ContainsSubstring("nodes[0], meshes[0].primitives[0]: this part has no material"));

    gltf.document["nodes"][0]["scale"] = {1, 0, 1};
    folder.write("one.gltf", gltf.text());
    const auto flat =
        errorOf([&] { return loadScene(folder.write("scene.yaml", sceneWith(object + ", material: mine}\n"))); });
    REQUIRE(flat);
    CHECK(flat->where().line == 5);
    CHECK_THAT(flat->what(), ContainsSubstring("singular"));
}
