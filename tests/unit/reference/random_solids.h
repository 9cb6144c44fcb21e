// Solids of every kind at random places, and CSG trees of them.
#pragma once

#include "unit/reference/support.h"

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace hyalite::reference::test {

inline constexpr double kEndless = std::numeric_limits<double>::infinity();

// Turned, stretched by 0.5 to 1.5 along each axis (mirrored now and then), and moved.
inline glm::dmat4 randomMap(Random& random, double place) {
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), random.inCube(place));
    const glm::dmat4 turned = glm::rotate(moved, random.between(0, 6), random.direction());
    const dvec3 stretch(random.between(0.5, 1.5), random.between(0.5, 1.5), random.between(0.5, 1.5));
    return glm::scale(turned, random.unit() < 0.2 ? -stretch : stretch);
}

// x^2 + y^2 + z^2 <= 1 and its relatives about the y axis: the signs of the squares, and the constant.
inline QuadricForm diagonalForm(double x, double y, double z, double constant) {
    return {.a = x, .e = y, .h = z, .j = constant};
}

inline Quadric axisBox(const dvec3& low, const dvec3& high) {
    return {.form = {.j = -1}, .clip = {low, high}, .capped = true, .objectToWorld = glm::dmat4(1)};
}

// Without end along an axis.
inline Quadric endlessCylinder(int axis, double radius) {
    dvec3 squares(1);
    squares[axis] = 0;
    return {.form = diagonalForm(squares.x, squares.y, squares.z, -radius * radius)};
}

// Twelve triangles, outwards.
inline Mesh cubeMesh() {
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.emplace_back(corner & 1, (corner >> 1) & 1, corner >> 2);
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

// The octahedron, each edge halved twice and pushed onto the unit sphere.
inline Mesh ballMesh() {
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < 2; ++level) {
        std::vector<glm::uvec3> finer;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
            return static_cast<std::uint32_t>(mesh.positions.size() - 1);
        };
        for (const glm::uvec3& t : mesh.triangles) { // the same middle twice, by value
            const glm::uvec3 m(middle(std::min(t.x, t.y), std::max(t.x, t.y)),
                               middle(std::min(t.y, t.z), std::max(t.y, t.z)),
                               middle(std::min(t.z, t.x), std::max(t.z, t.x)));
            finer.insert(finer.end(), {{t.x, m.x, m.z}, {m.x, t.y, m.y}, {m.z, m.y, t.z}, m});
        }
        mesh.triangles = finer;
    }
    return mesh;
}

// Any coefficients, within a box of a size like the others'.
inline Quadric randomQuadric(Random& random, double place) {
    const auto c = [&] { return random.between(-1, 1); };
    return {.form = {c(), c(), c(), c(), c(), c(), c(), c(), c(), c()},
            .clip = {{-1, -1, -1}, {1, 1, 1}},
            .capped = true,
            .objectToWorld = randomMap(random, place)};
}

inline constexpr int kSolidKinds = 12;

// Scene::meshes[0] must be cubeMesh(), [1] ballMesh(). Planes, the last kind, are the only ones without end.
inline Shape randomSolid(Random& random, int kind, double place) {
    const glm::dmat4 map = randomMap(random, place);
    const Bounds tall{{-kEndless, -1, -kEndless}, {kEndless, 1, kEndless}};
    const Bounds around{{-1, -1, -1}, {1, 1, 1}};
    switch (kind) {
    case 0:
        return Sphere{random.inCube(place), random.between(0.3, 1)};
    case 1:
        return Quadric{
            .form = diagonalForm(1, 1, 1, -1), .clip = Bounds::everything(), .capped = true, .objectToWorld = map};
    case 2:
        return Quadric{.form = {.j = -1}, .clip = around, .capped = true, .objectToWorld = map};
    case 3: // cylinder
        return Quadric{.form = diagonalForm(1, 0, 1, -0.5), .clip = tall, .capped = true, .objectToWorld = map};
    case 4: // cone with both halves
        return Quadric{.form = diagonalForm(1, -1, 1, 0), .clip = tall, .capped = true, .objectToWorld = map};
    case 5: // hyperboloid of one sheet
        return Quadric{.form = diagonalForm(1, -1, 1, -0.1), .clip = tall, .capped = true, .objectToWorld = map};
    case 6: // the outside of a hyperboloid of two sheets, in a box
        return Quadric{.form = diagonalForm(-1, 1, -1, -0.1), .clip = around, .capped = true, .objectToWorld = map};
    case 7: { // paraboloid
        QuadricForm form = diagonalForm(1, 0, 1, -1);
        form.g = 0.5;
        return Quadric{.form = form, .clip = tall, .capped = true, .objectToWorld = map};
    }
    case 8:
        return randomQuadric(random, place);
    case 9:
        return Torus{.major = random.between(0.5, 1), .minor = random.between(0.1, 0.45), .objectToWorld = map};
    case 10:
        return MeshInstance{.mesh = random.unit() < 0.5 ? 0U : 1U, .objectToWorld = map};
    default:
        return Plane{random.inCube(place), random.direction()};
    }
}

// Appends a csg object: a random tree of so many leaves, and the unit ball of radius `within` about the origin in whose
// intersection it lies. Leaves have the materials 0, 1, 2, ...
inline void addRandomTree(Random& random, Scene& scene, std::size_t leafCount, double within) {
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random.unit() * static_cast<double>(n)); };
    Csg csg{.firstLeaf = scene.csgLeaves.size(), .program = {}};
    const auto addLeaf = [&](const Shape& shape) {
        csg.program.push_back(CsgStep::Leaf);
        const std::size_t material = scene.csgLeaves.size() - csg.firstLeaf;
        scene.csgLeaves.push_back({.shape = shape, .material = material, .emission = dvec3(0), .where = {}});
    };
    // A random decision joins operands at any time: trees of all shapes occur.
    const std::array operations{CsgStep::Union, CsgStep::Union, CsgStep::Intersection, CsgStep::Difference};
    std::size_t open = 0;
    for (std::size_t leaf = 0; leaf < leafCount || open > 1;) {
        if (open < 2 || (leaf < leafCount && random.unit() < 0.5)) {
            addLeaf(randomSolid(random, static_cast<int>(below(kSolidKinds)), 0.8));
            ++leaf;
            ++open;
        } else {
            csg.program.push_back(operations.at(below(4)));
            --open;
        }
    }
    addLeaf(Sphere{dvec3(0), within});
    csg.program.push_back(CsgStep::Intersection);
    scene.objects.push_back({.shape = csg, .material = std::nullopt, .emission = dvec3(0), .where = {}});
}

} // namespace hyalite::reference::test
