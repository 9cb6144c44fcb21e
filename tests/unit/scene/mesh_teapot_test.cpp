// The teapot: known points and extents of Newell's surface, its symmetry, counts, normals and open edges.
#include "unit/scene/mesh_test_support.h"

#include "scene/import/teapot.h"
#include "scene/import/teapot_patches.h"
#include "scene/model/mesh_topology.h"

#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <map>
#include <set>

using Catch::Matchers::WithinAbs;
using namespace hyalite;
using namespace hyalite::test;

namespace {

constexpr std::array<std::uint32_t, 4> kLevels{1, 2, 6, 33};

bool contains(const Mesh& mesh, const glm::vec3& point) {
    return std::any_of(mesh.positions.begin(), mesh.positions.end(),
                       [&](const glm::vec3& position) { return glm::length(position - point) < 1e-6F; });
}

glm::dvec3 faceNormal(const Mesh& mesh, const glm::uvec3& triangle) {
    const glm::dvec3 a = mesh.positions[triangle.x];
    return glm::cross(glm::dvec3(mesh.positions[triangle.y]) - a, glm::dvec3(mesh.positions[triangle.z]) - a);
}

// Edges that a triangle runs along and no other runs back.
std::size_t openEdges(const Mesh& mesh) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const glm::uvec3& t : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            edges.emplace(t[k], t[(k + 1) % 3]);
        }
    }
    return static_cast<std::size_t>(std::count_if(
        edges.begin(), edges.end(), [&](const auto& edge) { return !edges.contains({edge.second, edge.first}); }));
}

} // namespace

TEST_CASE("the classic teapot of 2256 triangles is level 6, and other levels make 64 n^2 - 8 n") {
    CHECK(makeTeapot(6).triangles.size() == 2256);
    for (const std::uint32_t level : kLevels) {
        // 32 patches of 2 n^2; eight of them have an edge of n segments that is one point.
        CHECK(makeTeapot(level).triangles.size() == std::size_t{64} * level * level - std::size_t{8} * level);
    }
}

TEST_CASE("the teapot's patches share their vertices") {
    for (const std::uint32_t level : kLevels) {
        const std::size_t n = level;
        // Around the axis 4n columns; body: 4 patches down, n rows each, the last row one point; lid: 2 patches, the
        // first row one point. Handle and spout: 2n columns around, 2 patches along, n rows each and one more.
        const std::size_t body = 4 * n * (4 * n) + 1;
        const std::size_t lid = 4 * n * (2 * n) + 1;
        std::size_t tube = 2 * n * (2 * n + 1);
        CHECK(makeTeapot(level).positions.size() == body + lid + 2 * tube);
    }
}

TEST_CASE("the teapot stands on the ground in Newell's units, y up") {
    const Mesh mesh = makeTeapot(40);
    Bounds box;
    for (const glm::vec3& position : mesh.positions) {
        box.add(position);
    }
    // Corners of patches lie on the surface: tip of the lid (0, 3.15), widest ring 2, end of the handle -3, none
    // beyond.
    CHECK(box.low.y == 0);
    CHECK_THAT(box.high.y, WithinAbs(3.15, 1e-6));
    CHECK(box.low.x == -3);
    CHECK(box.low.z == -2);
    CHECK(box.high.z == 2);
    // The spout's rim in the plane z = 0 is the cubic with x = 3.3, 3.525, 3.45, 3.2. Where x' = 0,
    // 0.225 (1-t)^2 - 0.15 t (1-t) - 0.25 t^2 = 0: 0.125 t^2 - 0.6 t + 0.225 = 0, t = 2.4 - sqrt(3.96) = 0.410025;
    // there x = 3.3 + 0.675 t - 0.9 t^2 + 0.125 t^3 = 3.434075; the
    // nearest of 40 steps is at most 1/80 away, where x is lower by at most |x''| / 2 / 80^2 < 1.6 / 12800 = 1.25e-4.
    CHECK(box.high.x <= 3.434076);
    CHECK(box.high.x >= 3.434075 - 1.25e-4);

    // Corners of patches, in the data's (x, y, z) -> (x, z, -y): rim, belly, foot, handle, spout.
    for (const glm::vec3& point : {glm::vec3(1.4F, 2.4F, 0), glm::vec3(0, 2.4F, 1.5F), glm::vec3(0, 0.9F, -2),
                                   glm::vec3(-1.5F, 0.15F, 0), glm::vec3(-2.7F, 1.8F, 0), glm::vec3(-1.9F, 0.6F, 0),
                                   glm::vec3(1.7F, 1.425F, 0), glm::vec3(3.2F, 2.4F, 0), glm::vec3(0.2F, 2.7F, 0)}) {
        INFO(point.x << ' ' << point.y << ' ' << point.z);
        CHECK(contains(mesh, point));
    }
    // Middle of an edge of the belly: the cubic 1/8 (p0 + 3 p1 + 3 p2 + p3) of (1.5, 2.4), (1.75, 1.875), (2, 1.35),
    // (2, 0.9): x = (1.5 + 5.25 + 6 + 2) / 8, y = (2.4 + 5.625 + 4.05 + 0.9) / 8.
    CHECK(contains(mesh, {14.75F / 8, 12.975F / 8, 0}));
}

TEST_CASE("the teapot is its own image in the plane z = 0, and body and lid in x = 0 too") {
    std::map<std::size_t, int> shapes;
    for (const BicubicPatch& patch : teapotPatches()) {
        ++shapes[static_cast<std::size_t>(patch.part)];
    }
    CHECK(shapes == std::map<std::size_t, int>{{0, 16}, {1, 8}, {2, 4}, {3, 4}}); // body, lid, handle, spout

    const Mesh mesh = makeTeapot(5);
    for (const glm::vec3& position : mesh.positions) {
        CHECK(contains(mesh, position * glm::vec3(1, 1, -1)));
        if (std::abs(position.x) < 1.4F) { // all of it is body and lid, but for the top of the handle's two ends
            CHECK(contains(mesh, position * glm::vec3(-1, 1, 1)));
        }
    }
}

TEST_CASE("the teapot's normals are unit vectors and turned to the front of its triangles, at its poles too") {
    const Mesh mesh = makeTeapot(33);
    REQUIRE(mesh.normals.size() == mesh.positions.size());
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        CHECK_THAT(glm::length(mesh.normals[i]), WithinAbs(1, 1e-6));
        if (mesh.positions[i] == glm::vec3(0, 3.15F, 0)) { // the patches are level there
            CHECK(glm::length(mesh.normals[i] - glm::vec3(0, 1, 0)) < 1e-6F);
        }
        if (mesh.positions[i] == glm::vec3(0)) {
            CHECK(glm::length(mesh.normals[i] - glm::vec3(0, -1, 0)) < 1e-6F);
        }
        if (mesh.positions[i] == glm::vec3(2, 0.9F, 0)) { // the control points above and below are upright
            CHECK(glm::length(mesh.normals[i] - glm::vec3(1, 0, 0)) < 1e-6F);
        }
    }
    for (const glm::uvec3& triangle : mesh.triangles) {
        const glm::dvec3 normal = faceNormal(mesh, triangle);
        REQUIRE(glm::length(normal) > 0);
        for (int corner = 0; corner < 3; ++corner) {
            CHECK(glm::dot(normal, glm::dvec3(mesh.normals[triangle[corner]])) > 0);
        }
    }
    CHECK_FALSE(isInsideOut(mesh));
}

TEST_CASE("the teapot is open at the ends of its parts, and nowhere else") {
    for (const std::uint32_t level : {2U, 6U, 33U}) {
        const Mesh mesh = makeTeapot(level);
        CHECK(findOpenEdge(mesh));
        // The rim's inner edge and the lid's lower one have 4 n segments each, both ends of handle and spout 2 n each.
        CHECK(openEdges(mesh) == std::size_t{16} * level);
    }
}

TEST_CASE("a scene's teapots of one level share a mesh, and its levels have an end") {
    TemporaryFolder folder;
    const std::string begin =
        "hyalite: 1\nmaterials: {m: {type: mirror}}\nlights: [{type: point, position: [0, 9, 0]}]\n"
        "objects:\n  - {shape: {type: teapot";
    const std::string scene = begin + "}, material: m}\n  - {shape: {type: teapot, level: 6}, material: m, transform: "
                                      "[{translate: [5, 0, 0]}]}\n  - {shape: {type: teapot, level: 2}, material: m}\n";
    const Scene loaded = loadScene(folder.write("scene.yaml", scene));
    REQUIRE(loaded.meshes.size() == 2);
    CHECK(loaded.meshes[0].triangles.size() == 2256); // the default level is 6
    REQUIRE(loaded.objects.size() == 3);
    CHECK(std::get<MeshInstance>(loaded.objects[1].shape).mesh == 0);
    CHECK(std::get<MeshInstance>(loaded.objects[2].shape).mesh == 1);

    for (const std::string level : {"0", "1025", "2.5", "many"}) {
        const auto error =
            errorOf([&] { return loadScene(folder.write("scene.yaml", begin + ", level: " + level + "}}")); });
        REQUIRE(error);
        CHECK(error->where().line == 5);
        CHECK(error->where().column == 35); // after "  - {shape: {type: teapot, level: "
    }
}
