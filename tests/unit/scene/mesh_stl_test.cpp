// STL import: text and binary, told apart whatever they begin with, welded, and every mistake with its place.
#include "unit/scene/mesh_test_support.h"

#include "scene/import/mesh_import.h"
#include "scene/model/mesh_topology.h"

#include <cctype>
#include <limits>

using namespace hyalite;
using namespace hyalite::test;

namespace {

// The pyramid's six triangles in its corners' order.
std::string textPyramid(const std::string& name = "pyramid") {
    std::string text = "solid " + name + "\n";
    for (const glm::uvec3& triangle : kTriangles) {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3 p = kCorners[triangle[corner]];
            text +=
                "      vertex " + std::to_string(p.x) + ' ' + std::to_string(p.y) + ' ' + std::to_string(p.z) + '\n';
        }
        text += "    endloop\n  endfacet\n";
    }
    return text + "endsolid " + name + '\n';
}

std::string binaryPyramid(std::string header = "made by hand") {
    header.resize(80, ' ');
    put(header, static_cast<std::uint32_t>(kTriangles.size()), false);
    for (const glm::uvec3& triangle : kTriangles) {
        for (int axis = 0; axis < 3; ++axis) {
            put(header, std::numeric_limits<float>::quiet_NaN(), false); // a normal that readers must ignore
        }
        for (int corner = 0; corner < 3; ++corner) {
            for (int axis = 0; axis < 3; ++axis) {
                put(header, kCorners[triangle[corner]][axis], false);
            }
        }
        put(header, std::uint16_t{0xabcd}, false);
    }
    return header;
}

// Welding keeps the order in which corners are first used: 0, 1, 2, 3, and 4 with the first side.
void checkWeldedPyramid(const std::string& bytes) {
    const Mesh mesh = parseStl(bytes, "pyramid.stl");
    checkPyramid(mesh);
    CHECK_FALSE(findOpenEdge(mesh));
}

} // namespace

TEST_CASE("a pyramid is the same welded mesh from text and from binary STL") {
    checkWeldedPyramid(textPyramid());
    checkWeldedPyramid(binaryPyramid());
}

TEST_CASE("a binary STL file that begins like text is recognised by its size") {
    checkWeldedPyramid(binaryPyramid("solid pyramid\nfacet normal 0 0 0"));
}

TEST_CASE("text STL may be written in capitals, without a name, with Windows' line ends and as several solids") {
    std::string text = textPyramid("");
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) {
        text.insert(at, 1, '\r');
    }
    checkWeldedPyramid(text);

    const Mesh twice = parseStl(textPyramid("one endsolid facet") + textPyramid("two"), "two.stl");
    CHECK(twice.positions == kCorners);
    CHECK(twice.triangles.size() == 2 * kTriangles.size());
}

TEST_CASE("the ending .stl names the format, in capitals too") {
    TemporaryFolder folder;
    checkPyramid(importMesh(folder.write("pyramid.STL", binaryPyramid()), {}));
}

TEST_CASE("a mistake in text STL is reported at its word") {
    const std::string begin = "solid x\n facet normal 0 0 1\n  outer loop\n";
    const std::string corners = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
    struct Case {
        std::string marked;
        std::string what;
    };
    const std::vector<Case> cases{
        {"solid x\n $face normal 0 0 1\n", "expected 'endsolid', found 'face'"},
        {"solid x\n facet $norm 0 0 1\n", "expected 'normal', found 'norm'"},
        {"solid x\n facet normal 0 0 $outer\n", "expected a number, found 'outer'"},
        {begin + "vertex 0 $zero 0\n", "expected a number, found 'zero'"},
        {begin + "vertex 0 0 $nan\n", "not a finite number"},
        {begin + "vertex 0 $-2e9 0\n", "-2e+09 is too large"},
        {begin + "vertex 0 0 0\nvertex 0 0 1\n  $endloop", "expected 'vertex', found 'endloop'"},
        {begin + corners + "$vertex 1 1 1\n", "expected 'endloop', found 'vertex'"},
        {begin + corners + "endloop\nendfacet\n$", "expected 'endsolid', found the end of the file"},
        {begin + corners + "endloop\nendfacet\nendsolid x\n$facet", "expected 'solid', found 'facet'"},
    };
    for (const Case& bad : cases) {
        checkRejected(parseStl, bad.marked, bad.what);
    }
    checkRejected(parseStl, "solid nothing\nendsolid nothing\n", "the mesh has no triangles");
}

TEST_CASE("a mistake in binary STL is reported with its triangle and byte") {
    std::string bytes = binaryPyramid();
    // The y coordinate of the second corner of the third triangle.
    constexpr std::size_t kPlace = 84 + 2 * 50 + 12 + 12 + 4;
    std::string infinite;
    put(infinite, std::numeric_limits<float>::infinity(), false);
    bytes.replace(kPlace, 4, infinite);
    checkRejected(parseStl, bytes, "triangle 3, byte 212: a coordinate is not a finite number"); // 84 + 128

    std::string empty(80, ' ');
    put(empty, std::uint32_t{0}, false);
    checkRejected(parseStl, empty, "the mesh has no triangles");
}

TEST_CASE("a binary STL file that is truncated, or promises more than it holds, is an error") {
    const std::string whole = binaryPyramid("solid, or so it says");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        INFO(size << " of " << whole.size() << " bytes");
        CHECK(errorOf([&] { return parseStl(std::string_view(whole).substr(0, size), "cut.stl"); }));
    }
    CHECK(errorOf([&] { return parseStl(whole + '\0', "long.stl"); }));
    std::string huge(80, ' ');
    put(huge, std::uint32_t{0xffffffff}, false); // 215 GB
    checkRejected(parseStl, huge + "1234", "declares 4294967295 triangles of 50 bytes, 4 bytes follow");
}
