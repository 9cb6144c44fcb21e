// Meshes of glass: closed or open, wound outward or inward, and what is done about it.
#include "scene/model/mesh_shells.h"
#include "unit/scene/scene_test_support.h"

#include <array>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <iomanip>
#include <sstream>

using namespace hyalite;
using namespace hyalite::test;

namespace {

// Cubes of an OBJ file, whose faces are squares.
class Obj {
public:
    // Centre and half the edge [m]; `outward`: the faces' orientation; `without` and `flipped`: faces left out or wound
    // the other way round, 0..5, or -1.
    Obj& cube(const glm::dvec3& center, double half, bool outward = true, int without = -1, int flipped = -1) {
        constexpr std::array<std::array<int, 4>, 6> kFaces{
            // bits of a corner: x, y, z
            {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
        for (int corner = 0; corner < 8; ++corner) {
            text_ << "v " << center.x + ((corner & 1) != 0 ? half : -half) << ' '
                  << center.y + ((corner & 2) != 0 ? half : -half) << ' '
                  << center.z + ((corner & 4) != 0 ? half : -half) << '\n';
        }
        for (int face = 0; face < 6; ++face) {
            std::array<int, 4> corners = kFaces.at(static_cast<std::size_t>(face));
            if (outward == (face == flipped)) {
                std::swap(corners[1], corners[3]);
            }
            if (face != without) {
                text_ << "f";
                for (const int corner : corners) {
                    text_ << ' ' << corners_ + corner + 1;
                }
                text_ << '\n';
            }
        }
        corners_ += 8;
        return *this;
    }
    [[nodiscard]] std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
    int corners_ = 0;
};

Scene load(const std::string& objects, const std::string& mesh = {}) {
    TemporaryFolder folder;
    if (!mesh.empty()) {
        folder.write("mesh.obj", mesh);
    }
    return loadScene(
        folder.write("scene.yaml", "hyalite: 1\nlights: [{type: point, position: [0, 9, 0]}]\n"
                                   "materials: {a: {type: diffuse}, g: {type: dielectric, ior: 1.5}, "
                                   "n: {type: dielectric, ior: 1}, t: {type: dielectric, thin: true}}\nobjects:\n" +
                                       objects));
}

Scene glassMesh(const Obj& obj, const std::string& rest = "") {
    return load("  - {shape: {type: mesh, file: mesh.obj}, material: g" + rest + "}\n", obj.text());
}

double volumeOf(const Scene& scene, std::size_t object = 0) {
    double volume = 0;
    for (const MeshShell& shell : shellsOf(scene.meshes[std::get<MeshInstance>(scene.objects[object].shape).mesh])) {
        CHECK(shell.turned.empty());
        volume += shell.volume;
    }
    return volume;
}

void checkQuiet(const std::string& objects, const std::string& mesh = {}) {
    INFO(objects);
    const Scene scene = load(objects, mesh);
    for (const Warning& warning : scene.warnings) {
        UNSCOPED_INFO(warning.text());
    }
    CHECK(scene.warnings.empty());
}

void checkOpen(const std::string& objects, int line, const std::string& mesh = {}) {
    INFO(objects);
    const Scene scene = load(objects, mesh);
    REQUIRE(scene.warnings.size() == 1);
    INFO(scene.warnings[0].text());
    CHECK(scene.warnings[0].kind == WarningKind::OpenGlass);
    CHECK(scene.warnings[0].where.line == line);
}

std::string quad(const std::string& corner, const std::string& edge0, const std::string& edge1,
                 const std::string& material = "g") {
    return "  - {shape: {type: quad, corner: " + corner + ", edges: [" + edge0 + ", " + edge1 +
           "]}, material: " + material + "}\n";
}

} // namespace

TEST_CASE("shells: a cube's volume, a flipped face, an open edge, a cube of separate triangles") {
    const auto shells = [](const Obj& obj) {
        return shellsOf(load("  - {shape: {type: mesh, file: mesh.obj}, material: a}\n", obj.text()).meshes[0]);
    };
    const auto cube = shells(Obj().cube({5, 0, 0}, 0.5));
    REQUIRE(cube.size() == 1);
    CHECK(cube[0].isSolid());
    CHECK_THAT(cube[0].volume, Catch::Matchers::WithinRel(1.0, 1e-6));
    CHECK_THAT(cube[0].area, Catch::Matchers::WithinRel(6.0, 1e-6));

    const auto flipped = shells(Obj().cube({0, 0, 0}, 0.5, true, -1, 3));
    REQUIRE(flipped.size() == 1);
    CHECK(flipped[0].isSolid());
    CHECK(flipped[0].turned == std::vector<std::uint32_t>{6, 7});
    CHECK_THAT(flipped[0].volume, Catch::Matchers::WithinRel(1.0, 1e-6));

    const auto open = shells(Obj().cube({0, 0, 0}, 0.5, true, 5));
    REQUIRE(open.size() == 1);
    CHECK(!open[0].isSolid());
    CHECK(open[0].open.size() == 4); // of the eight triangles beside the missing face's edges, those that have one

    CHECK(shells(Obj().cube({0, 0, 0}, 0.5).cube({3, 0, 0}, 0.5, false)).size() == 2);
}

TEST_CASE("corners that an exporter rounded apart are one corner") {
    // A tetrahedron whose faces have corners of their own, each coordinate rounded up or down in the sixth digit
    const std::array<glm::dvec3, 4> corners{{{1.23456, 0, 0}, {2.34567, 1.11111, 0}, {2.2, 0, 1.3}, {1.9, 0.6, 2.1}}};
    const std::array<std::array<std::size_t, 3>, 4> faces{{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
    Mesh mesh;
    std::uint32_t count = 0;
    for (const auto& face : faces) {
        for (const std::size_t corner : face) {
            const double rounding = (count * 7 % 3) * 1e-5 - 1e-5; // -1, 0 or 1 in the last digit
            mesh.positions.emplace_back(corners.at(corner) + (count % 2 == 0 ? 0.5 : 0.0) * rounding);
            ++count;
        }
        mesh.triangles.emplace_back(count - 3, count - 2, count - 1);
    }
    const auto shells = shellsOf(mesh);
    REQUIRE(shells.size() == 1);
    CHECK(shells[0].isSolid());
    CHECK(shells[0].turned.empty());
}

TEST_CASE("glass wound inward is turned, under a mirroring transform too, and its first face is named") {
    for (const std::string transform : {"", ", transform: [{scale: [-1, 1, 1]}]"}) {
        const Scene scene = glassMesh(Obj().cube({0, 0, 0}, 0.5, false), transform);
        CHECK_THAT(volumeOf(scene), Catch::Matchers::WithinRel(1.0, 1e-6));
        REQUIRE(scene.warnings.size() == 1);
        CHECK(scene.warnings[0].kind == WarningKind::TurnedFaces);
        CHECK(scene.warnings[0].where.file == scene.meshes[0].file);
        CHECK(scene.warnings[0].where.line == 9);
        CHECK_THAT(scene.warnings[0].what, Catch::Matchers::ContainsSubstring("its 12 faces are turned"));
    }
    CHECK(glassMesh(Obj().cube({0, 0, 0}, 0.5), ", transform: [{scale: [-1, 1, 1]}]").warnings.empty());
}

TEST_CASE("single faces wound inward are turned, and the first of them is named") {
    const Scene outward = glassMesh(Obj().cube({0, 0, 0}, 0.5, true, -1, 3));
    CHECK_THAT(volumeOf(outward), Catch::Matchers::WithinRel(1.0, 1e-6));
    REQUIRE(outward.warnings.size() == 1);
    CHECK(outward.warnings[0].where.line == 12); // the fourth face
    CHECK_THAT(outward.warnings[0].what, Catch::Matchers::ContainsSubstring("2 faces"));
    const Scene first = glassMesh(Obj().cube({0, 0, 0}, 0.5, true, -1, 0)); // the face that the others are compared to
    CHECK_THAT(volumeOf(first), Catch::Matchers::WithinRel(1.0, 1e-6));
    CHECK(first.warnings.at(0).where.line == 9);
}

TEST_CASE("a hollow, a bubble in another solid and a solid in a hollow are wound rightly") {
    const Scene hollow = glassMesh(Obj().cube({0, 0, 0}, 1).cube({0, 0, 0}, 0.5, false).cube({0.1, 0, 0}, 0.2));
    CHECK(hollow.warnings.empty());
    CHECK_THAT(volumeOf(hollow), Catch::Matchers::WithinRel(8 - 1 + 0.064, 1e-6));
    const std::string inward = Obj().cube({0, 0, 0}, 0.5, false).text();
    for (const std::string around : {"sphere, radius: 2", "box, min: [-1, -1, -1], max: [1, 1, 1]"}) {
        checkQuiet("  - {shape: {type: mesh, file: mesh.obj}, material: g}\n  - {shape: {type: " + around +
                       "}, material: g}\n",
                   inward);
    }
    // Beside a solid it is no bubble
    const Scene beside = load("  - {shape: {type: mesh, file: mesh.obj}, material: g}\n"
                              "  - {shape: {type: sphere, center: [3, 0, 0], radius: 2}, material: g}\n",
                              inward);
    CHECK_THAT(volumeOf(beside), Catch::Matchers::WithinRel(1.0, 1e-6));
}

TEST_CASE("what is not glass keeps its faces, also where it shares a mesh with glass") {
    const Scene scene =
        load("  - {shape: {type: mesh, file: mesh.obj}, material: a}\n"
             "  - {shape: {type: mesh, file: mesh.obj}, material: g, transform: [{translate: [3, 0, 0]}]}\n"
             "  - {shape: {type: mesh, file: mesh.obj}, material: n, transform: [{translate: [6, 0, 0]}]}\n",
             Obj().cube({0, 0, 0}, 0.5, false).text());
    CHECK_THAT(volumeOf(scene, 0), Catch::Matchers::WithinRel(-1.0, 1e-6));
    CHECK_THAT(volumeOf(scene, 1), Catch::Matchers::WithinRel(1.0, 1e-6));
    CHECK_THAT(volumeOf(scene, 2), Catch::Matchers::WithinRel(-1.0, 1e-6));
    CHECK(scene.warnings.size() == 1);
}

TEST_CASE("single sheets of glass are reported at their place") {
    checkOpen(quad("[0, 0, 0]", "[1, 0, 0]", "[0, 1, 0]"), 5);
    checkOpen("  - {shape: {type: disk, radius: 1, normal: [0, 1, 0]}, material: g}\n", 5);
    checkOpen("  - {shape: {type: cylinder, base: [0, 0, 0], top: [0, 1, 0], radius: 1, open: true}, material: g}\n",
              5);
    checkOpen("  - {shape: {type: mesh, file: mesh.obj}, material: g}\n", 9, // the first face beside the missing one
              Obj().cube({0, 0, 0}, 0.5, true, 5).text());
    checkOpen("  - {shape: {type: mesh, file: mesh.obj}, material: g}\n", 4, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    // Two faces of a pane without its narrow sides
    CHECK(load(quad("[0, 0, 0]", "[1, 0, 0]", "[0, 1, 0]") + quad("[0, 0, -0.1]", "[0, 1, 0]", "[1, 0, 0]"))
              .warnings.size() == 2);
}

TEST_CASE("sheets of glass that close a space together, or with opaque walls, are a solid") {
    const std::string x = "[1, 0, 0]";
    const std::string y = "[0, 1, 0]";
    const std::string z = "[0, 0, 1]";
    // A cube of six quads with their fronts outward
    const std::string sides =
        quad("[0, 0, 0]", z, y) + quad("[1, 0, 0]", y, z) + quad("[0, 0, 0]", y, x) + quad("[0, 0, 1]", x, y);
    checkQuiet(sides + quad("[0, 0, 0]", x, z) + quad("[0, 1, 0]", z, x));
    // Water between opaque walls
    const std::string pool = quad("[0, 0, 0]", z, y, "a") + quad("[1, 0, 0]", y, z, "a") +
                             quad("[0, 0, 0]", y, x, "a") + quad("[0, 0, 1]", x, y, "a") + quad("[0, 0, 0]", x, z, "a");
    checkQuiet(pool + quad("[0, 0.8, 0]", z, x));
    // A rod: an open cylinder and two disks
    checkQuiet("  - {shape: {type: cylinder, base: [0, 0, 0], top: [0, 1, 0], radius: 1, open: true}, material: g}\n"
               "  - {shape: {type: disk, radius: 1, normal: [0, -1, 0]}, material: g}\n"
               "  - {shape: {type: disk, center: [0, 1, 0], radius: 1, normal: [0, 1, 0]}, material: g}\n");
}

TEST_CASE("closed glass, a half-space of it, index 1 and thin glass are no sheets") {
    checkQuiet("  - {shape: {type: sphere, radius: 1}, material: g}\n"
               "  - {shape: {type: cylinder, base: [3, 0, 0], top: [3, 1, 0], radius: 1}, material: g}\n"
               "  - {shape: {type: plane, point: [0, -2, 0], normal: [0, 1, 0]}, material: g}\n" +
               quad("[9, 0, 0]", "[1, 0, 0]", "[0, 1, 0]", "n") + quad("[9, 0, 1]", "[1, 0, 0]", "[0, 1, 0]", "t"));
    checkQuiet("  - {shape: {type: mesh, file: mesh.obj}, material: g}\n", Obj().cube({0, 0, 0}, 0.5).text());
}
