// See teapot.h.
#include "scene/import/teapot.h"

#include "scene/import/teapot_patches.h"
#include "scene/model/mesh_weld.h"

#include <algorithm>
#include <array>
#include <span>

namespace hyalite {
namespace {

// Cubic Bernstein polynomials at i / n, and their derivatives.
struct Weights {
    std::array<double, 4> value;
    std::array<double, 4> slope;

    Weights(std::uint32_t i, std::uint32_t n) {
        const double t = static_cast<double>(i) / n;
        const double s = static_cast<double>(n - i) / n; // exact at both ends, where patches meet
        value = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
        slope = {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
    }
};

glm::dvec3 blend(const BicubicPatch& patch, const std::array<double, 4>& u, const std::array<double, 4>& v) {
    glm::dvec3 sum(0);
    for (std::size_t row = 0; row < 4; ++row) {
        glm::dvec3 point(0);
        for (std::size_t column = 0; column < 4; ++column) {
            point += v[column] * patch.points[row][column];
        }
        sum += u[row] * point;
    }
    return sum;
}

glm::dvec3 normal(const BicubicPatch& patch, const Weights& u, const Weights& v) {
    const glm::dvec3 alongU = blend(patch, u.slope, v.value);
    glm::dvec3 alongV = blend(patch, u.value, v.slope);
    constexpr double kPoint = 1e-9; // the pot's own derivatives are above 0.01
    if (glm::dot(alongV, alongV) < kPoint * kPoint) {
        // A whole row is one point: the derivative vanishes there like u times the mixed one, or like 1 - u times
        // its opposite.
        alongV = blend(patch, u.slope, v.slope) * (u.value[0] == 1 ? 1.0 : -1.0);
    }
    return glm::normalize(glm::cross(alongV, alongU));
}

// From the data's space to y up.
glm::dvec3 yUp(const glm::dvec3& p) {
    return {p.x, p.z, -p.y};
}

// Appends the patches of one part, sharing vertices among them.
void addPart(std::span<const BicubicPatch> patches, std::uint32_t level, Mesh& mesh) {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    for (const BicubicPatch& patch : patches) {
        for (std::uint32_t i = 0; i <= level; ++i) {
            const Weights u(i, level);
            for (std::uint32_t j = 0; j <= level; ++j) {
                const Weights v(j, level);
                positions.emplace_back(yUp(blend(patch, u.value, v.value)));
                normals.emplace_back(yUp(normal(patch, u, v)));
            }
        }
    }

    std::vector<std::uint32_t> index = weldPositions(positions);
    for (std::uint32_t i = 0; i < index.size(); ++i) {
        if (index[i] == i) {
            index[i] = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.push_back(positions[i]);
            mesh.normals.push_back(normals[i]); // of all patches that meet here: they meet smoothly
        } else {
            index[i] = index[index[i]];
        }
    }

    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::uvec3 triangle(index[a], index[b], index[c]);
        if (triangle.x != triangle.y && triangle.y != triangle.z && triangle.z != triangle.x) {
            mesh.triangles.push_back(triangle);
        }
    };
    const std::uint32_t row = level + 1;
    for (std::uint32_t patch = 0; patch < patches.size(); ++patch) {
        for (std::uint32_t i = 0; i < level; ++i) {
            for (std::uint32_t j = 0; j < level; ++j) {
                const std::uint32_t corner = patch * row * row + i * row + j;
                add(corner, corner + row + 1, corner + row);
                add(corner, corner + 1, corner + row + 1);
            }
        }
    }
}

} // namespace

Mesh makeTeapot(std::uint32_t level) {
    const std::vector<BicubicPatch> patches = teapotPatches();
    Mesh mesh;
    mesh.file = "teapot of level " + std::to_string(level);
    mesh.triangles.reserve(std::size_t{64} * level * level);
    for (auto begin = patches.begin(); begin != patches.end();) {
        const auto end =
            std::find_if(begin, patches.end(), [&](const auto& patch) { return patch.part != begin->part; });
        addPart({begin, end}, level, mesh);
        begin = end;
    }
    return mesh;
}

} // namespace hyalite
