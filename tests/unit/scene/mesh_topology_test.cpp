// Closed and open meshes: small solids by hand, with repeated positions, degenerate triangles and holes.
#include "scene/model/mesh_topology.h"
#include "scene/model/mesh_weld.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <utility>

using Catch::Matchers::WithinRel;
using namespace hyalite;

namespace {

// Two units long, three high, four deep; the two triangles of a side face outward.
Mesh box() {
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.emplace_back((corner & 1) != 0 ? 2 : 0, (corner & 2) != 0 ? 3 : 0, (corner & 4) != 0 ? 4 : 0);
    }
    mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return mesh;
}

// The same triangles, each with corners of its own.
Mesh soup(const Mesh& mesh) {
    Mesh apart;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(apart.positions.size());
        for (int corner = 0; corner < 3; ++corner) {
            apart.positions.push_back(mesh.positions[triangle[corner]]);
        }
        apart.triangles.emplace_back(first, first + 1, first + 2);
    }
    return apart;
}

} // namespace

TEST_CASE("equal positions are welded to the first of them, 0 and -0 included") {
    const std::vector<glm::vec3> positions{{0, 1, 2}, {1, 0, 2}, {-0.0F, 1, 2}, {1, 0, 2.5F}, {1, -0.0F, 2}};
    CHECK(weldPositions(positions) == std::vector<std::uint32_t>{0, 1, 0, 3, 1});
    CHECK(weldPositions(std::span<const glm::vec3>()).empty());
}

TEST_CASE("a million positions on a line are welded in pairs") {
    constexpr std::uint32_t kCount = 1000000;
    std::vector<glm::vec3> positions;
    for (std::uint32_t i = 0; i < 2 * kCount; ++i) {
        positions.emplace_back(static_cast<float>(i % kCount), 0, 0);
    }
    const std::vector<std::uint32_t> first = weldPositions(positions);
    bool allPaired = true;
    for (std::uint32_t i = 0; i < 2 * kCount; ++i) {
        allPaired = allPaired && first[i] == i % kCount;
    }
    CHECK(allPaired);
}

TEST_CASE("a box is closed, whether its triangles share vertices or repeat them") {
    CHECK_FALSE(findOpenEdge(box()));
    CHECK_FALSE(findOpenEdge(soup(box())));
}

TEST_CASE("a missing triangle leaves an open edge, named as its neighbour runs along it") {
    Mesh mesh = box();
    mesh.triangles.pop_back(); // (4, 7, 6); its neighbours run 7 4, 6 7 and 4 6
    const auto edge = findOpenEdge(mesh);
    REQUIRE(edge);
    const auto is = [&](std::size_t from, std::size_t to) {
        return edge->from == mesh.positions[from] && edge->to == mesh.positions[to];
    };
    CHECK((is(7, 4) || is(6, 7) || is(4, 6)));
}

TEST_CASE("a triangle with the opposite orientation of its neighbours leaves open edges") {
    Mesh mesh = box();
    std::swap(mesh.triangles[3].y, mesh.triangles[3].z);
    CHECK(findOpenEdge(mesh));
}

TEST_CASE("a wall with two sheets on one side is open") {
    Mesh mesh = box();
    mesh.triangles.push_back(mesh.triangles[0]); // each of its edges is now run along twice, and back once
    CHECK(findOpenEdge(mesh));
}

TEST_CASE("boxes that touch along an edge are closed") {
    // Four triangles meet at the common edge, two of them in each direction.
    Mesh mesh = box();
    for (const glm::uvec3& triangle : box().triangles) {
        mesh.triangles.push_back(triangle + 8U);
    }
    for (const glm::vec3& corner : box().positions) {
        mesh.positions.push_back(corner + glm::vec3(2, 3, 0)); // corners 0 and 4 of it are 3 and 7 of the first
    }
    CHECK_FALSE(findOpenEdge(mesh));
}

TEST_CASE("triangles with two corners in one place change nothing") {
    Mesh mesh = box();
    mesh.positions.push_back(mesh.positions[5]);
    mesh.triangles.emplace_back(1, 1, 2);
    mesh.triangles.emplace_back(5, 0, 8); // 8 stands where 5 stands
    mesh.triangles.emplace_back(3, 3, 3);
    CHECK_FALSE(findOpenEdge(mesh));
    mesh.triangles.erase(mesh.triangles.begin());
    CHECK(findOpenEdge(mesh));
}

TEST_CASE("a mesh of only degenerate triangles, or of none, is closed and empty") {
    Mesh mesh;
    CHECK_FALSE(findOpenEdge(mesh));
    CHECK_FALSE(isInsideOut(mesh));
    mesh.positions = {{0, 0, 0}, {1, 0, 0}};
    mesh.triangles = {{0, 1, 1}};
    CHECK_FALSE(findOpenEdge(mesh));
    CHECK(signedVolume(mesh) == 0);
}

TEST_CASE("the volume of a box is the product of its sides, negative inside out, wherever it stands") {
    Mesh mesh = box();
    for (glm::vec3& corner : mesh.positions) {
        corner += glm::vec3(1e6F, -2e6F, 3e6F); // whole numbers below 2^24: exact
    }
    CHECK_THAT(signedVolume(mesh), WithinRel(2.0 * 3 * 4, 1e-12));
    CHECK_FALSE(isInsideOut(mesh));
    for (glm::uvec3& triangle : mesh.triangles) {
        std::swap(triangle.x, triangle.y);
    }
    CHECK_THAT(signedVolume(mesh), WithinRel(-2.0 * 3 * 4, 1e-12));
    CHECK(isInsideOut(mesh));
    CHECK_FALSE(findOpenEdge(mesh));
}
