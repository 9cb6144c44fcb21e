// OBJ and PLY import: the same small mesh in every encoding, normals, polygons, and every mistake with its place.
#include "unit/scene/mesh_test_support.h"

#include "scene/import/mesh_import.h"

#include <cmath>

using namespace hyalite;
using namespace hyalite::test;

namespace {

std::string asciiPyramid() {
    std::string text = "ply\nformat ascii 1.0\ncomment a pyramid\nelement vertex 5\nproperty float x\nproperty float "
                       "y\nproperty float z\nelement face 5\nproperty list uchar int vertex_indices\nend_header\n";
    text += "0 0 0\n1 0 0\n1 0 1\n0 0 1\n0.5 2 0.5\n4 0 1 2 3\n3 1 0 4\n3 2 1 4\n3 3 2 4\n3 0 3 4\n";
    return text;
}

// The pyramid with extra properties and elements, lists among them, which a reader must step over.
std::string binaryPyramid(bool bigEndian) {
    std::string bytes = std::string("ply\nformat binary_") + (bigEndian ? "big" : "little") +
                        "_endian 1.0\nelement camera 2\nproperty double focal\nproperty list ushort short pixels\n"
                        "element vertex 5\nproperty uchar red\nproperty float x\nproperty list int double weights\n"
                        "property double y\nproperty float z\nproperty short flags\n"
                        "element face 5\nproperty list uchar float texcoord\nproperty list int uint vertex_index\n"
                        "property uchar material\nend_header\n";
    for (int camera = 0; camera < 2; ++camera) {
        put(bytes, 35.0, bigEndian);
        put(bytes, std::uint16_t{3}, bigEndian);
        for (const auto pixel : std::array<std::int16_t, 3>{-1, 0, 1}) {
            put(bytes, pixel, bigEndian);
        }
    }
    for (const glm::vec3& corner : kCorners) {
        put(bytes, std::uint8_t{255}, bigEndian);
        put(bytes, corner.x, bigEndian);
        put(bytes, std::int32_t{1}, bigEndian);
        put(bytes, 0.125, bigEndian);
        put(bytes, static_cast<double>(corner.y), bigEndian);
        put(bytes, corner.z, bigEndian);
        put(bytes, std::int16_t{-7}, bigEndian);
    }
    for (const auto& face : kFaces) {
        put(bytes, std::uint8_t{2}, bigEndian);
        put(bytes, 0.5F, bigEndian);
        put(bytes, 0.25F, bigEndian);
        put(bytes, static_cast<std::int32_t>(face.size()), bigEndian);
        for (const std::uint32_t index : face) {
            put(bytes, index, bigEndian);
        }
        put(bytes, std::uint8_t{9}, bigEndian);
    }
    return bytes;
}

const std::string kPlyTop = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

} // namespace

TEST_CASE("a pyramid is the same mesh from OBJ and from ascii and binary PLY of both byte orders") {
    checkPyramid(parseObj("# pyramid\nmtllib x.mtl\no pyramid\nv 0 0 0\nv 1 0 0 1.0\nv 1 0 1 0.5 0.5 0.5\nv 0 0 1\n"
                          "v .5 2e0 +0.5\ng base\nusemtl stone\ns off\nf 1 2 3 4\nf 2 1 5\r\nf 3 2 5 # a side\n"
                          "f 4 \\\n 3 5\n\tf 1 4 5",
                          "pyramid.obj"));
    checkPyramid(parsePly(asciiPyramid(), "pyramid.ply"));
    checkPyramid(parsePly(binaryPyramid(false), "pyramid.ply"));
    checkPyramid(parsePly(binaryPyramid(true), "pyramid.ply"));
}

TEST_CASE("a PLY header may end its lines like Windows does") {
    std::string text = asciiPyramid();
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) {
        text.insert(at, 1, '\r');
    }
    checkPyramid(parsePly(text, "pyramid.ply"));
}

TEST_CASE("negative OBJ indices count back from the last vertex before the face") {
    const Mesh mesh = parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -4 -3 -1\n", "m.obj");
    CHECK(mesh.triangles == std::vector<glm::uvec3>{{0, 1, 2}, {0, 1, 3}});
}

TEST_CASE("OBJ texture coordinates need no normals") {
    const Mesh mesh = parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 0.5 1\nf 1/1 2/2 3/-1\n", "m.obj");
    CHECK(mesh.triangles == std::vector<glm::uvec3>{{0, 1, 2}});
    CHECK(mesh.uvs == std::vector<glm::vec2>{{0, 0}, {0.5F, 1}, {0.5F, 1}});
    CHECK(mesh.normals.empty());
}

TEST_CASE("an OBJ position is repeated for each normal it is used with") {
    // Two triangles share an edge; vertex 1 has one normal in both, vertex 3 has two.
    const Mesh mesh = parseObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 2\nvn 3 0 4\nvt 0 0\n"
                               "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/2 4/1/2\n",
                               "m.obj");
    CHECK(trianglesOf(mesh) ==
          std::vector<Triangle>{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}, {{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}});
    // (1, 1), (2, 1), (3, 1), (3, 2), (4, 2): five pairs; normals of length one.
    REQUIRE(mesh.positions.size() == 5);
    REQUIRE(mesh.normals.size() == 5);
    CHECK(mesh.triangles[0].x == mesh.triangles[1].x);
    CHECK(mesh.normals[mesh.triangles[0].z] == glm::vec3(0, 0, 1));
    CHECK(mesh.normals[mesh.triangles[1].y] == glm::vec3(0.6F, 0, 0.8F));
}

TEST_CASE("a face without normals in an OBJ mesh that has some stays flat") {
    const Mesh mesh =
        parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0.6 0 0.8\nf 1//1 2//1 3//1\nf 1 3 4\n", "m.obj");
    REQUIRE(mesh.normals.size() == 6);
    for (int corner = 0; corner < 3; ++corner) {
        CHECK(mesh.normals[mesh.triangles[0][corner]] == glm::vec3(0.6F, 0, 0.8F));
        CHECK(mesh.normals[mesh.triangles[1][corner]] == glm::vec3(1, 0, 0)); // y x z
    }
}

TEST_CASE("PLY vertex normals become unit normals of the same vertices") {
    const Mesh mesh = parsePly("ply\nformat ascii 1.0\nelement vertex 3\nproperty float nx\nproperty float ny\n"
                               "property float nz\nproperty float x\nproperty float y\nproperty float z\n"
                               "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                               "0 0 2 0 0 0\n3 0 4 1 0 0\n0 -1 0 0 1 0\n3 0 1 2\n",
                               "m.ply");
    CHECK(trianglesOf(mesh) == std::vector<Triangle>{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}});
    REQUIRE(mesh.normals.size() == 3);
    CHECK(mesh.normals[mesh.triangles[0].x] == glm::vec3(0, 0, 1));
    CHECK(mesh.normals[mesh.triangles[0].y] == glm::vec3(0.6F, 0, 0.8F));
    CHECK(mesh.normals[mesh.triangles[0].z] == glm::vec3(0, -1, 0));
}

TEST_CASE("a zero normal of a PLY vertex is an error where a face uses it, and only there") {
    const auto mesh = [](const std::string& face) {
        return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
               "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n"
               "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 1 0 0 0 0\n" +
               face;
    };
    const Mesh unused = parsePly(mesh("3 0 1 2\n"), "m.ply");
    for (const glm::vec3& normal : unused.normals) {
        CHECK(glm::length(normal) == 1);
    }
    checkRejected(parsePly, mesh("$3 0 1 3\n"), "face 1: a vertex normal is zero");
}

TEST_CASE("an arrowhead is split at its concave corner, and a worse polygon is refused") {
    // The dent (corner 1) lies inside the triangle of the others: only the diagonal from it lies inside the polygon.
    const Mesh mesh = parseObj("v 0 0 0\nv 0.4 0.4 0\nv 0 2 0\nv -3 0 0\nf 2 3 4 1\n", "dent-first.obj");
    CHECK(mesh.triangles == std::vector<glm::uvec3>{{1, 2, 3}, {1, 3, 0}});
    const Mesh arrow = parseObj("v 2 0 0\nv 0 1 0\nv 0.5 0 0\nv 0 -1 0\nf 1 2 3 4\n", "arrow.obj");
    CHECK(arrow.triangles == std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}});
    const Mesh turned = parseObj("v 2 0 0\nv 0 1 0\nv 0.5 0 0\nv 0 -1 0\nf 2 3 4 1\n", "arrow.obj");
    CHECK(turned.triangles == std::vector<glm::uvec3>{{2, 3, 0}, {2, 0, 1}});

    // A U: no corner sees all the others.
    checkRejected(parseObj,
                  "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\n$f 1 2 3 4 5 6 7 8\n",
                  "face 1: polygon is not convex");
}

TEST_CASE("a polygon of many corners becomes two triangles fewer") {
    std::string text;
    std::string face = "f";
    for (int i = 1; i <= 100; ++i) {
        const double angle = i * 2 * 3.14159265358979 / 100;
        text += "v " + std::to_string(std::cos(angle)) + ' ' + std::to_string(std::sin(angle)) + " 0\n";
        face += ' ' + std::to_string(i);
    }
    CHECK(parseObj(text + face, "disc.obj").triangles.size() == 98);
}

TEST_CASE("the test models are closed surfaces that face outward") {
    const Mesh icosahedron = importMesh(kSourceFolder / "scenes/models/icosahedron.obj", {});
    CHECK(icosahedron.triangles.size() == 20);
    CHECK(icosahedron.normals.empty());
    // 12 rings of 24 sectors: 2 caps of 24 triangles, 10 rings of 24 quadrilaterals.
    const Mesh sphere = importMesh(kSourceFolder / "scenes/models/uv-sphere.ply", {});
    CHECK(sphere.triangles.size() == 2 * 24 + 10 * 24 * 2);
    REQUIRE(sphere.normals.size() == sphere.positions.size());
    for (std::size_t i = 0; i < sphere.normals.size(); ++i) {
        CHECK(glm::length(sphere.normals[i] - sphere.positions[i]) < 1e-6F);
    }
    for (const Mesh* mesh : {&icosahedron, &sphere}) {
        for (const Triangle& t : trianglesOf(*mesh)) {
            CHECK(glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), t[0] + t[1] + t[2]) > 0);
        }
    }
}

TEST_CASE("mistakes in an OBJ file are reported with line and column") {
    const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    struct Case {
        std::string marked;
        std::string what;
    };
    const std::vector<Case> cases{
        {"# nothing\n", "the mesh has no triangles"},
        {three, "the mesh has no triangles"},
        {three + "f 1 2 $4\n", "the index 4 of a vertex is out of range (3 precede this face"},
        {three + "f 1 2 $0\n", "the index 0 of a vertex"},
        {three + "f $-4 2 3\n", "the index -4 of a vertex"},
        {three + "f 1 2 $99999999999999999999\n", "expected the index of a vertex"},
        {three + "f 1 $two 3\n", "expected the index of a vertex, found 'two'"},
        {three + "f 1 2 $3.0\n", "expected the index of a vertex"},
        {three + "f $1//1 2//1 3//1\n", "the index 1 of a normal is out of range (0 precede"},
        {three + "f $1/1 2/1 3/1\n", "the index 1 of a texture coordinate"},
        {three + "f $1/ 2 3\n", "expected the index of a texture coordinate, found ''"},
        {three + "f $1// 2 3\n", "expected the index of a normal, found ''"},
        {three + "vn 0 0 1\nf $1//1/1 2 3\n", "expected the index of a normal, found '1/1'"},
        {three + "$f 1 2\n", "face has 2 corners"},
        {three + "$f\n", "face has 0 corners"},
        {"v 0 0 0\n$v 1 0\n", "'v' is followed by 2 numbers"},
        {"v 0 $x 0\n", "expected a number, found 'x'"},
        {"v 0 $nan 0\n", "not a finite number"},
        {"v 0 0 $-inf\n", "not a finite number"},
        {"v 0 0 $1e999\n", "not a finite number"},
        {"v 0 $1e30 0\n", "the coordinate 1e+30 is too large"},
        {"$vn 0 1\n", "'vn' is followed by 2 numbers"},
        {three + "vn 0 0 0\n$f 1//1 2//1 3//1\n", "a vertex normal is zero"},
        {"$curv 0 1 1 2\n", "unknown or unsupported statement 'curv'"},
        {"$<html>\n", "unknown or unsupported statement '<html>'"},
    };
    for (const Case& bad : cases) {
        checkRejected(parseObj, bad.marked, bad.what);
    }
}

TEST_CASE("mistakes in an ascii PLY file are reported with line and column") {
    struct Case {
        std::string marked;
        std::string what;
    };
    const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
    const std::vector<Case> cases{
        {"$plyx\n", "not a PLY file"},
        {"ply\n$", "unexpected end of file in the header"},
        {"ply\nformat ascii 1.0\n$", "unexpected end of file in the header"},
        {"ply\n$format ascii 2.0\n", "expected 'format'"},
        {"ply\n$format binary 1.0\n", "unknown PLY format 'binary'"},
        {"ply\n$end_header\n", "the header has no 'format' line"},
        {"ply\nformat ascii 1.0\nend_header\n", "the file has no vertices"},
        {"ply\nformat ascii 1.0\n$property float x\n", "property before the first element"},
        {"ply\nformat ascii 1.0\n$element vertex -3\n", "expected 'element'"},
        {"ply\nformat ascii 1.0\n$element vertex many\n", "expected 'element'"},
        {"ply\nformat ascii 1.0\nelement vertex 3\n$element vertex 3\n", "duplicate element 'vertex'"},
        {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n$property float x\n", "duplicate property 'x'"},
        {"ply\nformat ascii 1.0\nelement vertex 3\n$property real x\n", "unknown type 'real'"},
        {"ply\nformat ascii 1.0\nelement face 3\n$property list float int vertex_indices\n", "whole-number type"},
        {"ply\n$nonsense\n", "unknown header line"},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
         "the vertices have no property 'z'"},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 1\nproperty list uchar int corners\nend_header\n0 0 0\n3 0 0 0\n",
         "no list 'vertex_indices'"},
        {kPlyTop + "0 0 0\n1 0 $\n0 1 0\n3 0 1 2\n", "vertex 2: the line holds fewer values"},
        {kPlyTop + "0 0 0\n1 0 0 $5\n0 1 0\n3 0 1 2\n", "vertex 2: the line holds more values"},
        {kPlyTop + "0 0 0\n1 0 $x\n0 1 0\n3 0 1 2\n", "vertex 2: expected a number, found 'x'"},
        {kPlyTop + "0 0 0\n1 $nan 0\n0 1 0\n3 0 1 2\n", "not a finite number"},
        {kPlyTop + vertices + "3 0 1 $3\n", "face 1: the index 3 of a vertex is out of range (there are 3"},
        {kPlyTop + vertices + "3 0 $-1 2\n", "the index -1 of a vertex"},
        {kPlyTop + vertices + "3 0 $1.5 2\n", "expected a whole number, found '1.5'"},
        {kPlyTop + vertices + "3 0 $4294967296 2\n", "does not fit the type"}, // 2^32
        {kPlyTop + vertices + "$2 0 1\n", "face has 2 corners"},
        {kPlyTop + vertices + "$0\n", "face has 0 corners"},
        {kPlyTop + vertices + "$200 0 1 2\n", "declares 200 values, but the line ends first"},
        {kPlyTop + vertices + "$-3 0 1 2\n", "does not fit the type"},
        {kPlyTop + vertices, "declares 1 of 'face'"},
        {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 0\nproperty list uchar int vertex_indices\nend_header\n" +
             vertices,
         "the mesh has no triangles"},
        {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n" +
             vertices,
         "the mesh has no triangles"},
    };
    for (const Case& bad : cases) {
        checkRejected(parsePly, bad.marked, bad.what);
    }
}

TEST_CASE("a PLY file cut off anywhere is an error, never a mesh or a crash") {
    for (const bool bigEndian : {false, true}) {
        const std::string whole = binaryPyramid(bigEndian);
        for (std::size_t size = 1; size < whole.size(); ++size) {
            INFO(size << " of " << whole.size() << " bytes");
            CHECK(errorOf([&] { return parsePly(std::string_view(whole).substr(0, size), "cut.ply"); }).has_value());
        }
    }
}

TEST_CASE("counts that the file cannot hold are refused before anything is allocated") {
    // Each would need gigabytes or more.
    const std::string top = "ply\nformat binary_little_endian 1.0\n";
    const std::string vertex = "property float x\nproperty float y\nproperty float z\n";
    const std::vector<std::string> files{
        top + "element vertex 9000000000000000000\n" + vertex + "end_header\n1234567890",
        top + "element vertex 4000000000\n" + vertex + "end_header\n",
        top + "element vertex 0\n" + vertex +
            "element face 4000000000\nproperty list uchar int vertex_indices\nend_header\n",
        top + "element vertex 0\n" + vertex +
            "element face 1\nproperty list uint uint vertex_indices\nend_header\n\xff\xff\xff\xff____",
        top + "element vertex 0\n" + vertex +
            "element face 1\nproperty list int uint vertex_indices\nend_header\n\xff\xff\xff\xff____",
        std::string("ply\nformat ascii 1.0\nelement vertex 4000000000\n") + vertex + "end_header\n0 0 0\n",
        // An element without properties takes no room: its count must cost nothing.
        top + "element nothing 9000000000000000000\nelement vertex 0\n" + vertex + "end_header\n",
    };
    for (const std::string& text : files) {
        INFO(text);
        CHECK(errorOf([&] { return parsePly(text, "huge.ply"); }).has_value());
    }
}
