#include "bench/mesh_room.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

namespace hyalite::bench {

namespace {

using glm::dvec2;
using glm::dvec3;

// Adds the image of the unit square: columns x rows quads, each of two triangles.
void addPatch(Mesh& mesh, std::uint32_t columns, std::uint32_t rows, const std::function<dvec3(dvec2)>& point) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column <= columns; ++column) {
            mesh.positions.emplace_back(point(dvec2(column, row) / dvec2(columns, rows)));
        }
    }
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = first + row * (columns + 1) + column;
            const std::uint32_t c = a + columns + 1;
            mesh.triangles.emplace_back(a, a + 1, c);
            mesh.triangles.emplace_back(a + 1, c + 1, c);
        }
    }
}

// Waves that vanish at the square's edges, so that walls meet.
double bumps(dvec2 uv, double waves) {
    const dvec2 window = uv * (1.0 - uv);
    return 16 * window.x * window.y * std::sin(waves * uv.x) * std::sin(waves * uv.y + 1.3 * std::sin(9 * uv.x));
}

// A wall from `corner`, with bumps along `inward`.
void addWall(Mesh& mesh, const dvec3& corner, const dvec3& u, const dvec3& v, const dvec3& inward) {
    constexpr std::uint32_t kSteps = 80;
    addPatch(mesh, kSteps, kSteps,
             [&](dvec2 uv) { return corner + uv.x * u + uv.y * v + 0.06 * bumps(uv, 55) * inward; });
}

void addPillar(Mesh& mesh, const dvec3& foot, double height) {
    constexpr std::uint32_t kSectors = 48;
    constexpr std::uint32_t kRows = 30;
    addPatch(mesh, kSectors, kRows, [&](dvec2 uv) {
        const double angle = 2 * std::numbers::pi * uv.x;
        const double radius = 0.22 + 0.03 * std::cos(8 * angle) + 0.05 * std::cos(2 * std::numbers::pi * uv.y);
        return foot + dvec3(radius * std::cos(angle), height * uv.y, radius * std::sin(angle));
    });
}

void addBall(Mesh& mesh, const dvec3& center, double radius, double phase) {
    constexpr std::uint32_t kRings = 32;
    addPatch(mesh, 2 * kRings, kRings, [&](dvec2 uv) {
        const double phi = 2 * std::numbers::pi * uv.x;
        const double theta = std::numbers::pi * uv.y;
        const double uneven = std::sin(theta) * std::sin(5 * phi + phase) * std::sin(7 * theta);
        return center + radius * (1 + 0.12 * uneven) *
                            dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
    });
}

} // namespace

Mesh makeMeshRoom() {
    Mesh mesh;
    mesh.file = "mesh-room";
    const dvec3 x(8, 0, 0), y(0, 4, 0), z(0, 0, 8);
    addWall(mesh, {-4, 0, -4}, z, x, {0, 1, 0});
    addWall(mesh, {-4, 4, -4}, x, z, {0, -1, 0});
    addWall(mesh, {-4, 0, -4}, x, y, {0, 0, 1});
    addWall(mesh, {4, 0, 4}, -x, y, {0, 0, -1});
    addWall(mesh, {-4, 0, 4}, -z, y, {1, 0, 0});
    addWall(mesh, {4, 0, -4}, z, y, {-1, 0, 0});
    for (int i = 0; i < 4; ++i) {
        addPillar(mesh, {i % 2 == 0 ? -2.2 : 2.2, 0, i < 2 ? -2.4 : 1.2}, 4);
    }
    for (int i = 0; i < 8; ++i) {
        const double angle = 0.8 * i;
        const double radius = 0.3 + 0.04 * (i % 3);
        addBall(mesh, {(0.7 + 0.22 * i) * std::cos(angle), radius + (i % 2) * 0.9, (0.5 + 0.2 * i) * std::sin(angle)},
                radius, i);
    }
    return mesh;
}

} // namespace hyalite::bench
