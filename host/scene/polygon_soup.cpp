// See polygon_soup.h.
#include "scene/polygon_soup.h"

#include "scene/numbers.h"
#include "scene/scene_limits.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>

namespace hyalite {
namespace {

class MeshBuilder {
public:
    MeshBuilder(const PolygonSoup& soup, const std::string& file) : soup_(soup) {
        mesh_.file = file;
        isSmooth_ = std::any_of(soup.corners.begin(), soup.corners.end(),
                                [](const Corner& corner) { return corner.normal != kNoNormal; });
    }

    Mesh build() {
        checkCount();
        if (!isSmooth_) {
            mesh_.positions = soup_.positions;
        }
        std::size_t begin = 0;
        for (std::size_t i = 0; i < soup_.polygons.size(); ++i) {
            const Polygon& polygon = soup_.polygons[i];
            addPolygon(i, std::span(soup_.corners).subspan(begin, polygon.end - begin));
            begin = polygon.end;
        }
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(std::size_t polygon, const std::string& what, const std::string& hint) const {
        const int line = soup_.polygons[polygon].line;
        throw Error(ExitCode::BadInput, SourceLocation{mesh_.file, line, line > 0 ? 1 : 0},
                    "face " + std::to_string(polygon + 1) + ": " + what, hint);
    }

    void checkCount() const {
        // A polygon of n corners makes n - 2 triangles.
        checkTriangleCount(soup_.corners.size() - 2 * soup_.polygons.size(), mesh_.file);
    }

    [[nodiscard]] glm::dvec3 position(const Corner& corner) const { return soup_.positions[corner.position]; }

    // Twice the area of the triangle of three corners, as a vector along its normal.
    [[nodiscard]] glm::dvec3 areaVector(const Corner& a, const Corner& b, const Corner& c) const {
        return glm::cross(position(b) - position(a), position(c) - position(a));
    }

    // Whether the fan from this corner covers a polygon: none of its triangles is turned against the whole.
    [[nodiscard]] bool isFan(std::span<const Corner> corners, std::size_t start, const glm::dvec3& area) const {
        constexpr double kRounding = 1e-6; // of the area: corners in a line may come out turned by a rounding error
        const std::size_t count = corners.size();
        for (std::size_t k = 1; k + 1 < count; ++k) {
            const glm::dvec3 part =
                areaVector(corners[start], corners[(start + k) % count], corners[(start + k + 1) % count]);
            if (glm::dot(part, area) < -kRounding * glm::dot(area, area)) {
                return false;
            }
        }
        return true;
    }

    void addPolygon(std::size_t index, std::span<const Corner> corners) {
        const std::size_t count = corners.size();
        glm::dvec3 area(0);
        for (std::size_t k = 1; k + 1 < count; ++k) {
            area += areaVector(corners[0], corners[k], corners[k + 1]);
        }
        // Trying two corners is enough for any quadrilateral, an arrowhead included.
        std::size_t start = 0;
        if (count > 3 && !isFan(corners, 0, area)) {
            start = 1;
            if (!isFan(corners, 1, area)) {
                fail(index, "a polygon that is not convex", "triangulate the mesh when exporting it");
            }
        }

        std::uint32_t flatNormal = kNoNormal; // made when a corner needs it
        std::vector<std::uint32_t> indices(count);
        for (std::size_t k = 0; k < count; ++k) {
            indices[k] = isSmooth_ ? smoothIndex(index, corners[k], area, flatNormal) : corners[k].position;
        }
        for (std::size_t k = 1; k + 1 < count; ++k) {
            mesh_.triangles.emplace_back(indices[start], indices[(start + k) % count],
                                         indices[(start + k + 1) % count]);
        }
    }

    // The mesh's index of a position together with its normal.
    std::uint32_t smoothIndex(std::size_t polygon, const Corner& corner, const glm::dvec3& area,
                              std::uint32_t& flatNormal) {
        std::uint32_t normalIndex = corner.normal;
        if (normalIndex == kNoNormal) {
            if (flatNormal == kNoNormal) {
                // Numbers after those of the soup stand for the flat polygons' own normals.
                flatNormal = static_cast<std::uint32_t>(soup_.normals.size() + flatPolygons_++);
            }
            normalIndex = flatNormal;
        }
        const std::uint64_t key = std::uint64_t{corner.position} << 32U | normalIndex;
        const auto [found, isNew] = indices_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
        if (isNew) {
            mesh_.positions.push_back(soup_.positions[corner.position]);
            mesh_.normals.push_back(corner.normal == kNoNormal ? flatDirection(area) : unitNormal(polygon, corner));
        }
        return found->second;
    }

    [[nodiscard]] glm::vec3 unitNormal(std::size_t polygon, const Corner& corner) const {
        const glm::dvec3 normal(soup_.normals[corner.normal]);
        const double length = glm::length(normal);
        if (!(length > 0)) {
            fail(polygon, "a vertex normal is zero", "export the mesh with valid normals or without any");
        }
        return normal / length;
    }

    // A polygon without area is never hit: any direction will do.
    [[nodiscard]] static glm::vec3 flatDirection(const glm::dvec3& area) {
        const double length = glm::length(area);
        return length > 0 ? glm::vec3(area / length) : glm::vec3(0, 0, 1);
    }

    const PolygonSoup& soup_;
    Mesh mesh_;
    bool isSmooth_ = false;
    std::size_t flatPolygons_ = 0;
    std::unordered_map<std::uint64_t, std::uint32_t> indices_;
};

} // namespace

Mesh buildMesh(const PolygonSoup& soup, const std::string& file) {
    return MeshBuilder(soup, file).build();
}

void checkTriangleCount(std::size_t count, const std::string& file) {
    if (count == 0) {
        throw Error(ExitCode::BadInput, SourceLocation{file, 0, 0}, "the mesh has no triangles");
    }
    if (count > kMostTriangles) {
        throw Error(ExitCode::BadInput, SourceLocation{file, 0, 0},
                    "the mesh has more than " + std::to_string(kMostTriangles) + " triangles");
    }
}

bool isMeshCoordinate(double value) {
    return std::abs(value) <= kLargestLength; // false for NaN
}

void failCoordinate(double value, const SourceLocation& where, const std::string& of) {
    if (!std::isfinite(value)) {
        throw Error(ExitCode::BadInput, where, of + "a coordinate is not a finite number");
    }
    throw Error(ExitCode::BadInput, where, of + "the coordinate " + numberText(value) + " is too large",
                "at most " + numberText(kLargestLength));
}

} // namespace hyalite
