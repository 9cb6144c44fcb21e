// Damaged and hostile glTF files: every mistake is an error that names its place, and nothing is allocated that the
// file does not hold.
#include "unit/scene/mesh_gltf_support.h"

#include <functional>
#include <limits>
#include <random>

using Catch::Matchers::ContainsSubstring;
using namespace hyalite;
using namespace hyalite::test;

namespace {

constexpr std::uint64_t kHuge = std::uint64_t{1} << 53U; // the largest whole number that JSON readers agree on

struct Case {
    std::function<void(json&)> spoil;
    std::string what;
};

// Each change makes the pyramid's file wrong in its own way.
void checkSpoilt(const std::vector<Case>& cases) {
    for (const Case& bad : cases) {
        Gltf gltf = pyramidGltf();
        bad.spoil(gltf.document);
        checkGltfRejected(gltf.text(), bad.what);
    }
}

json& positions(json& document) {
    return document["accessors"][0];
}
json& primitive(json& document) {
    return document["meshes"][0]["primitives"][0];
}

} // namespace

TEST_CASE("a glTF file that is not JSON is an error with line and column") {
    const auto error = errorOf([] { static_cast<void>(parse("{\n  \"asset\": {\"version\": 2.0,}\n}")); });
    REQUIRE(error);
    CHECK(error->where().line == 2);
    CHECK(error->where().column ==
          28); // the brace behind the comma: 2 + 8 + 1 + 1 + 10 + 1 + 3 + 1 characters are before it
    checkGltfRejected("", "JSON");
    checkGltfRejected("solid x", "JSON");
    checkGltfRejected("{\"a\": 1e999}", "JSON");
    checkGltfRejected(std::string(1000000, '['), "JSON");
    checkGltfRejected("[]", "expected an object, found a list of 0");
    checkGltfRejected("{}", "missing 'asset'");
    checkGltfRejected(R"({"asset": {"version": "1.0"}})", "asset.version: glTF '1.0' is not supported");
    checkGltfRejected(R"({"asset": {"version": "2.0"}})", "shows no triangles");
}

TEST_CASE("dangling references in a glTF file are named") {
    checkSpoilt({
        {[](json& d) { d["scene"] = 1; }, "scene: index 1 of 'scenes' is out of range"},
        {[](json& d) { d["scenes"][0]["nodes"][0] = 7; }, "scenes[0].nodes[0]: index 7 of 'nodes' is out of range"},
        {[](json& d) { d["nodes"][0]["mesh"] = 1; }, "nodes[0].mesh: index 1 of 'meshes' is out of range"},
        {[](json& d) { d["nodes"][0]["mesh"] = -1; }, "nodes[0].mesh: expected a whole number"},
        {[](json& d) { d["nodes"][0]["mesh"] = "0"; }, "nodes[0].mesh: expected a whole number"},
        {[](json& d) { d["nodes"][0]["mesh"] = 0.5; }, "found 0.5"},
        {[](json& d) { d["nodes"][0]["mesh"] = 1e300; }, "nodes[0].mesh: expected a whole number"},
        {[](json& d) { d["meshes"][0].erase("primitives"); }, "meshes[0]: missing 'primitives'"},
        {[](json& d) { primitive(d)["attributes"].erase("POSITION"); }, "missing 'POSITION'"},
        {[](json& d) { primitive(d)["attributes"]["POSITION"] = 2; }, "index 2 of 'accessors' is out of range"},
        {[](json& d) { primitive(d)["indices"] = 0; }, "needs an accessor of type 'SCALAR', found 'VEC3'"},
        {[](json& d) { primitive(d)["material"] = 0; }, "index 0 of 'materials' is out of range"},
        {[](json& d) { primitive(d)["mode"] = 7; }, "mode: expected a whole number in [0, 6], found 7"},
        {[](json& d) { positions(d)["bufferView"] = 9; }, "accessors[0].bufferView: index 9 of "},
        {[](json& d) { d["bufferViews"][0]["buffer"] = 1; }, "bufferViews[0].buffer: index 1 of "},
    });
}

TEST_CASE("accessors that reach beyond their views, and views beyond their buffers, are named") {
    checkSpoilt({
        {[](json& d) { positions(d)["count"] = 6; }, "accessors[0]: 6 elements of 12 bytes, one every 12 from byte 0"},
        {[](json& d) { positions(d)["count"] = kHuge; }, "beyond the end of 'bufferViews[0]' of 60 bytes"},
        {[](json& d) { positions(d)["count"] = 0; }, "accessors[0].count: expected a whole number in [1,"},
        {[](json& d) { positions(d)["byteOffset"] = 1; }, "from byte 1, go beyond the end"},
        {[](json& d) { positions(d)["byteOffset"] = kHuge; }, "go beyond the end"},
        {[](json& d) { positions(d)["byteOffset"] = kHuge + 2; }, "expected a whole number"},
        {[](json& d) { positions(d)["componentType"] = 5124; }, "unknown component type 5124"},
        {[](json& d) { positions(d)["type"] = "VEC2"; }, "needs an accessor of type 'VEC3', found 'VEC2'"},
        {[](json& d) { d["bufferViews"][0]["byteStride"] = 16; }, "one every 16 from byte 0, go beyond"},
        {[](json& d) { d["bufferViews"][0]["byteStride"] = 8; }, "elements of 12 bytes overlap at a stride of 8"},
        {[](json& d) { d["bufferViews"][0]["byteStride"] = 0; }, "expected a whole number in [1, 252]"},
        {[](json& d) { d["bufferViews"][1]["byteOffset"] = 100; }, "bufferViews[1]: 72 bytes from byte 100 go beyond"},
        {[](json& d) { d["bufferViews"][1]["byteOffset"] = kHuge; }, "go beyond the end of its buffer of 132 bytes"},
        {[](json& d) { d["bufferViews"][0]["byteLength"] = kHuge; }, "go beyond the end of its buffer of 132 bytes"},
        {[](json& d) { d["accessors"][1]["componentType"] = kFloat; }, "indices must be whole numbers without sign"},
        {[](json& d) { d["accessors"][1]["count"] = 17; }, "its 17 corners are not a multiple of 3"},
        {[](json& d) { positions(d)["count"] = 4; }, "the index 4 of a vertex is out of range"},
        {[](json& d) { primitive(d)["attributes"]["TEXCOORD_0"] = 1; },
         "needs an accessor of type 'VEC2', found 'SCALAR'"},
        {[](json& d) { primitive(d)["attributes"]["NORMAL"] = 0; }, "element 0: the normal is zero"},
    });
}

TEST_CASE("values that the device cannot hold are named with their element") {
    const auto spoilt = [](float value) {
        Gltf gltf;
        gltf.addPrimitive(gltf.addPositions({{0, 0, 0}, {1, value, 0}, {0, 1, 0}}));
        return gltf.text();
    };
    checkGltfRejected(spoilt(std::numeric_limits<float>::quiet_NaN()),
                      "accessors[0]: element 1: a coordinate is not a finite number");
    checkGltfRejected(spoilt(2e9F), "accessors[0]: element 1: the coordinate is too large");
}

TEST_CASE("sparse accessors must name existing elements, in order") {
    const auto spoilt = [](const std::vector<std::uint8_t>& indices, std::size_t count) {
        Gltf gltf = pyramidGltf();
        const std::size_t indexView = gltf.addView(bytesOf(indices));
        const std::size_t valueView = gltf.addView(std::string(24, '\0'));
        gltf.document["accessors"][0]["sparse"] = {
            {"count", count},
            {"indices", {{"bufferView", indexView}, {"componentType", kUnsignedByte}}},
            {"values", {{"bufferView", valueView}}}};
        return gltf.text();
    };
    CHECK(onlyMesh(spoilt({1, 2}, 2)).triangles.size() == 6);
    checkGltfRejected(spoilt({2, 1}, 2), "accessors[0].sparse.indices: number 1 of them is 1");
    checkGltfRejected(spoilt({1, 1}, 2), "they must ascend and be below 5");
    checkGltfRejected(spoilt({1, 5}, 2), "number 1 of them is 5");
    checkGltfRejected(spoilt({1, 2}, 3), "3 elements of 1 bytes");
    checkGltfRejected(spoilt({1, 2, 3}, 3), "accessors[0].sparse.values: 3 elements of 12 bytes");
    checkGltfRejected(spoilt({1, 2}, 6), "accessors[0].sparse.count: expected a whole number in [1, 5]");
}

TEST_CASE("nodes that do not form a tree, or have no valid transform, are named") {
    checkSpoilt({
        {[](json& d) { d["nodes"][0]["children"] = {0}; }, "nodes[0]: the node is reached more than once"},
        {[](json& d) {
             d["nodes"].push_back({{"children", {0}}});
             d["nodes"][0]["children"] = {1};
         },
         "nodes[0]: the node is reached more than once"},
        {[](json& d) { d["scenes"][0]["nodes"] = {0, 0}; }, "nodes[0]: the node is reached more than once"},
        {[](json& d) {
             d.erase("scenes"); // all nodes lie on a circle: none is a root
             d["nodes"][0]["children"] = {0};
         },
         "shows no triangles"},
        {[](json& d) { d["nodes"][0]["translation"] = {1, 2}; }, "nodes[0].translation: expected a list of 3 numbers"},
        {[](json& d) { d["nodes"][0]["scale"] = {1, 2, "3"}; }, "nodes[0].scale[2]: expected a number"},
        {[](json& d) { d["nodes"][0]["rotation"] = {0, 0, 0, 0}; }, "a rotation must be a unit quaternion"},
        {[](json& d) { d["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0}; }, "16 numbers"},
        {[](json& d) { d["nodes"][0]["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }, "last row"},
        {[](json& d) {
             d["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
             d["nodes"][0]["scale"] = {1, 1, 1};
         },
         "either a matrix or translation"},
    });
}

TEST_CASE("unsupported features are refused if they would change the shape, else ignored") {
    checkSpoilt({
        {[](json& d) { d["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
         "extensionsRequired[0]: the file requires the extension 'KHR_draco_mesh_compression'"},
        {[](json& d) { d["nodes"][0]["skin"] = 0; }, "nodes[0].skin: skinned meshes are not supported"},
        {[](json& d) {
             primitive(d)["targets"] = {{{"POSITION", 0}}};
             d["meshes"][0]["weights"] = {0.5};
         },
         "meshes[0].weights[0]: morph targets are not supported"},
        {[](json& d) { d["materials"] = {{{"pbrMetallicRoughness", {{"metallicFactor", 2}}}}}; },
         "materials[0].pbrMetallicRoughness.metallicFactor: expected a number in [0, 1], found 2"},
        {[](json& d) { d["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1}}}}}}; },
         "expected a list of 4 numbers, found one of 3"},
    });
    Gltf gltf = pyramidGltf();
    gltf.document["extensionsRequired"] = {"KHR_materials_unlit", "KHR_mesh_quantization"};
    primitive(gltf.document)["targets"] = {{{"POSITION", 0}}};
    gltf.document["meshes"][0]["weights"] = {0};
    checkPyramid(onlyMesh(gltf.text()));
}

TEST_CASE("buffers come from the file or from its folder, never from elsewhere") {
    TemporaryFolder folder;
    folder.write("secret.bin", pyramidGltf().buffer);
    const auto load = [&](const std::string& uri, std::size_t bytes) {
        Gltf gltf = pyramidGltf();
        gltf.document["buffers"] = {{{"uri", uri}, {"byteLength", bytes}}};
        return errorOf([&] { return importGltf(folder.write("models/m.gltf", gltf.text()), {}); });
    };
    const std::size_t size = pyramidGltf().buffer.size();
    for (const std::string& uri :
         {std::string("../secret.bin"), std::string("%2e%2E/secret.bin"), std::string("a/../../secret.bin"),
          (folder.path() / "secret.bin").string(), std::string("file:secret.bin"), std::string("..\\secret.bin"),
          std::string("https://example.org/a.bin"), std::string(""), std::string("%zz"), std::string("a%0"),
          std::string("a%00b")}) {
        INFO(uri);
        const auto error = load(uri, size);
        REQUIRE(error);
        CHECK_THAT(error->what(), ContainsSubstring("must be a file in the folder of the glTF file"));
    }
    folder.write("models/inside.bin", pyramidGltf().buffer);
    CHECK_FALSE(load("./inside.bin", size));
    CHECK_THAT(load("inside.bin", size + 1).value().what(),
               ContainsSubstring("buffers[0].byteLength: the buffer declares 133 bytes, but holds 132"));
    CHECK_THAT(load("missing.bin", size).value().what(), ContainsSubstring("no such file"));
    CHECK_THAT(load("data:text/plain,abc", size).value().what(), ContainsSubstring("must be base64"));
    CHECK_THAT(load("data:;base64,ab*d", size).value().what(), ContainsSubstring("not valid base64"));
    CHECK_THAT(load("data:;base64,AAAA", size).value().what(), ContainsSubstring("but holds 3"));
}

TEST_CASE("a binary glTF file cut off anywhere, or changed in its header, is an error") {
    const std::string whole = pyramidGltf().binary();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        INFO(size << " of " << whole.size() << " bytes");
        CHECK(errorOf([&] { static_cast<void>(parse(whole.substr(0, size))); }));
    }
    CHECK(errorOf([&] { static_cast<void>(parse(whole + '\0')); }));
    const auto changed = [&](std::size_t at, std::uint32_t value) {
        std::string bytes;
        put(bytes, value, false);
        return std::string(whole).replace(at, 4, bytes);
    };
    checkGltfRejected(changed(4, 1), "binary glTF version 1 is not supported");
    checkGltfRejected(changed(8, 100), "byte 8: the header declares 100 bytes");
    checkGltfRejected(changed(12, 0xffffffffU), "byte 12: a chunk of 4294967295 bytes goes beyond");
    checkGltfRejected(changed(16, 0x004e4942U), "byte 12: the first chunk is not JSON");
}

TEST_CASE("small glTF files that describe huge meshes are refused before anything is allocated") {
    Gltf zeros = pyramidGltf(); // 2^40 vertices of zeros: no bytes, but terabytes of corners
    zeros.document["accessors"][0] = {{"type", "VEC3"}, {"componentType", kFloat}, {"count", std::uint64_t{1} << 40U}};
    primitive(zeros.document).erase("indices");
    checkGltfRejected(zeros.text(), "elements without a buffer view in a file of");

    // A thousand primitives of the same 10 000 indices, each with another accessor, so that none shares a mesh.
    Gltf copies;
    copies.addPositions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const std::size_t view = copies.addView(std::string(30000, '\1'));
    for (int i = 0; i < 1000; ++i) {
        const std::size_t indices = copies.addAccessor(
            {{"bufferView", view}, {"type", "SCALAR"}, {"componentType", kUnsignedByte}, {"count", 30000}});
        copies.addPrimitive(0)["indices"] = indices;
    }
    checkGltfRejected(copies.text(), "at most 16 for each byte are read");

    // 2000 nodes that all show a mesh of 1000 primitives: two million objects.
    Gltf many = pyramidGltf();
    json& primitives = many.document["meshes"][0]["primitives"];
    primitives = json(1000, primitives[0]);
    many.document["nodes"] = json(2000, {{"mesh", 0}});
    many.document.erase("scenes");
    checkGltfRejected(many.text(), "shows more than 1048576 primitives");
}

TEST_CASE("glTF files with any byte changed are read or refused, nothing else") {
    const std::string whole = pyramidGltf().binary();
    std::mt19937 engine(5);
    int refused = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string bytes = whole;
        for (unsigned changes = 0; changes < 1 + engine() % 3; ++changes) {
            bytes[engine() % bytes.size()] = static_cast<char>(engine());
        }
        refused += errorOf([&] { static_cast<void>(mergeParts(parse(bytes))); }) ? 1 : 0;
    }
    CHECK(refused > 5000); // most changes of the JSON, which is most of the file
    CHECK(refused < 20000);
}
