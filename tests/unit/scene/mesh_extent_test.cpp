// Bounds of a mesh under transforms, by its sorted vertices against all of its triangles.
#include "scene/model/bounds.h"
#include "scene/model/mesh_extent.h"

#include <catch2/catch_test_macros.hpp>
#include <random>

using namespace hyalite;

namespace {

// Triangles between random points, all alike along the first `flat` axes. One more vertex, far away, is in none.
Mesh cloud(std::mt19937& random, int flat, std::size_t count) {
    std::normal_distribution<float> normal;
    Mesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        glm::vec3 point(normal(random), normal(random), normal(random));
        for (int axis = 0; axis < flat; ++axis) {
            point[axis] = 0.25F;
        }
        mesh.positions.push_back(point);
    }
    for (std::uint32_t i = 0; i + 2 < count; ++i) {
        mesh.triangles.emplace_back(i, i + 1, i + 2);
    }
    mesh.positions.emplace_back(100, 100, 100);
    return mesh;
}

} // namespace

TEST_CASE("a mesh's bounds under a transform are those of its triangles, to the bit") {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (const std::size_t count : {3, 40, 3000}) {
        for (int flat = 0; flat < 3; ++flat) {
            const Mesh mesh = cloud(random, flat, count);
            const MeshExtent extent(mesh);
            for (int i = 0; i < 200; ++i) {
                glm::dmat4 map(1);
                const double move = i % 3 == 0 ? 1e6 : i % 3 == 1 ? 1 : 0;
                for (int column = 0; column < 4; ++column) {
                    for (int row = 0; row < 3; ++row) {
                        map[column][row] = (column < 3 ? 1 : move) * normal(random);
                    }
                }
                const Bounds expected = meshBounds(mesh, map);
                const Bounds found = extent.under(map);
                REQUIRE((found.low == expected.low && found.high == expected.high));
            }
        }
    }
}

TEST_CASE("a mesh without triangles has no extent") {
    const Bounds none;
    const Bounds found = MeshExtent(Mesh{}).under(glm::dmat4(1));
    CHECK((found.low == none.low && found.high == none.high));
}
