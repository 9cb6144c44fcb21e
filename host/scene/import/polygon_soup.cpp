// See polygon_soup.h.
#include "scene/import/polygon_soup.h"

#include "base/numbers.h"
#include "scene/model/mesh_weld.h"
#include "scene/model/recentre.h"
#include "scene/model/repeated_faces.h"
#include "scene/model/scene_limits.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>

namespace hyalite {
namespace {

constexpr glm::vec3 kAnyDirection{0, 0, 1}; // for what is never seen

struct Vertex {
    std::uint32_t position;
    std::uint32_t normal;
    std::uint32_t uv;

    bool operator==(const Vertex&) const = default;
};

struct VertexHash {
    std::size_t operator()(const Vertex& vertex) const {
        std::uint64_t state = std::uint64_t{vertex.position} << 32U | vertex.normal;
        state = (state ^ state >> 29U) * 0xbf58476d1ce4e5b9U + vertex.uv;
        return static_cast<std::size_t>((state ^ state >> 32U) * 0x94d049bb133111ebU);
    }
};

// Where the coordinates of these points should start, so that floats resolve them.
glm::dvec3 originOf(std::span<const glm::dvec3> positions) {
    Bounds box;
    for (const glm::dvec3& position : positions) {
        box.add(position);
    }
    return positions.empty() ? glm::dvec3(0)
                             : originNear(0.5 * (box.low + box.high), glm::length(box.high - box.low) / 2);
}

class MeshBuilder {
public:
    MeshBuilder(PolygonSoup soup, const std::string& file) : soup_(std::move(soup)) {
        mesh_.file = file;
        mesh_.origin = originOf(soup_.positions);
        const auto hasNormal = [](const Corner& corner) { return corner.normal != kNoNormal; };
        const auto hasOwnNormal = [](const Corner& corner) { return corner.normal == corner.position; };
        const auto hasUv = [](const Corner& corner) { return corner.uv != kNoUv; };
        const auto hasOwnUv = [](const Corner& corner) { return corner.uv == corner.position; };
        isSmooth_ = std::any_of(soup_.corners.begin(), soup_.corners.end(), hasNormal);
        hasUvs_ = std::any_of(soup_.corners.begin(), soup_.corners.end(), hasUv);
        const bool normalsMatch = !isSmooth_ || (soup_.normals.size() == soup_.positions.size() &&
                                                 std::all_of(soup_.corners.begin(), soup_.corners.end(), hasOwnNormal));
        const bool uvsMatch = !hasUvs_ || (soup_.uvs.size() == soup_.positions.size() &&
                                           std::all_of(soup_.corners.begin(), soup_.corners.end(), hasOwnUv));
        numbersMatch_ = normalsMatch && uvsMatch;
    }

    Mesh build() {
        checkTriangleCount(triangles(), mesh_.file);
        mesh_.triangles.reserve(triangles());
        alignRepeatedPolygons();
        if (numbersMatch_ && isSmooth_) {
            makeUnitNormals();
        }
        std::size_t begin = 0;
        for (std::size_t i = 0; i < soup_.polygons.size(); ++i) {
            const Polygon& polygon = soup_.polygons[i];
            addPolygon(i, std::span(soup_.corners).subspan(begin, polygon.end - begin));
            begin = polygon.end;
        }
        if (numbersMatch_) {
            setPositions(mesh_, soup_.positions);
            mesh_.uvs = hasUvs_ ? std::move(soup_.uvs) : std::vector<glm::vec2>();
            mendUnusedNormals();
        }
        return std::move(mesh_);
    }

private:
    // Lets polygons that repeat earlier ones begin at the same corner, so that both are cut into the same triangles.
    void alignRepeatedPolygons() {
        if (triangles() == soup_.polygons.size()) {
            return; // there are only triangles
        }
        const std::vector<std::uint32_t> first = weldPositions(std::span<const glm::dvec3>(soup_.positions));
        std::vector<std::uint32_t> corners;
        std::vector<std::size_t> ends;
        for (const Corner& corner : soup_.corners) {
            corners.push_back(first[corner.position]);
        }
        for (const Polygon& polygon : soup_.polygons) {
            ends.push_back(polygon.end);
        }
        const std::vector<std::uint32_t> turns = turnsToRepeat(corners, ends);
        std::size_t begin = 0;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const std::span<Corner> polygon = std::span(soup_.corners).subspan(begin, ends[i] - begin);
            std::rotate(polygon.begin(), polygon.begin() + turns[i], polygon.end());
            begin = ends[i];
        }
    }

    // A polygon of n corners makes n - 2 triangles.
    [[nodiscard]] std::size_t triangles() const { return soup_.corners.size() - 2 * soup_.polygons.size(); }

    [[noreturn]] void fail(std::size_t polygon, const std::string& what, const std::string& hint) const {
        const int line = soup_.polygons[polygon].line;
        throw Error(ExitCode::BadInput, SourceLocation{mesh_.file, line, line > 0 ? 1 : 0},
                    "face " + std::to_string(polygon + 1) + ": " + what, hint);
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
                fail(index, "polygon is not convex", "triangulate the mesh when exporting it");
            }
        }

        std::uint32_t flatNormal = kNoNormal; // made when a corner needs it
        polygon_.clear();
        for (const Corner& corner : corners) {
            polygon_.push_back(vertexIndex(index, corner, area, flatNormal));
        }
        for (std::size_t k = 1; k + 1 < count; ++k) {
            mesh_.triangles.emplace_back(polygon_[start], polygon_[(start + k) % count],
                                         polygon_[(start + k + 1) % count]);
            if (soup_.polygons[index].line > 0) {
                mesh_.lines.push_back(static_cast<std::uint32_t>(soup_.polygons[index].line));
            }
        }
    }

    // One normal for each position, as in PLY files: no corner needs to be looked up.
    void makeUnitNormals() {
        mesh_.normals = std::move(soup_.normals);
        for (glm::vec3& normal : mesh_.normals) {
            const double length = glm::length(glm::dvec3(normal));
            normal = length > 0 ? glm::vec3(glm::dvec3(normal) / length) : glm::vec3(0);
        }
    }

    // Zero normals that no polygon uses are harmless.
    void mendUnusedNormals() { std::replace(mesh_.normals.begin(), mesh_.normals.end(), glm::vec3(0), kAnyDirection); }

    // The mesh's index of a position together with its normal and texture coordinates.
    std::uint32_t vertexIndex(std::size_t polygon, const Corner& corner, const glm::dvec3& area,
                              std::uint32_t& flatNormal) {
        if (numbersMatch_) {
            if (isSmooth_ && mesh_.normals[corner.normal] == glm::vec3(0)) {
                failZeroNormal(polygon);
            }
            return corner.position;
        }
        std::uint32_t normalIndex = corner.normal;
        if (isSmooth_ && normalIndex == kNoNormal) {
            if (flatNormal == kNoNormal) {
                // Numbers after those of the soup stand for the flat polygons' own normals.
                flatNormal = static_cast<std::uint32_t>(soup_.normals.size() + flatPolygons_++);
            }
            normalIndex = flatNormal;
        }
        const Vertex key{corner.position, normalIndex, corner.uv};
        const auto [found, isNew] = indices_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
        if (isNew) {
            mesh_.positions.emplace_back(soup_.positions[corner.position] - mesh_.origin);
            if (isSmooth_) {
                mesh_.normals.push_back(corner.normal == kNoNormal ? flatDirection(area) : unitNormal(polygon, corner));
            }
            if (hasUvs_) {
                mesh_.uvs.push_back(corner.uv == kNoUv ? glm::vec2(0) : soup_.uvs[corner.uv]);
            }
        }
        return found->second;
    }

    [[nodiscard]] glm::vec3 unitNormal(std::size_t polygon, const Corner& corner) const {
        const glm::dvec3 normal(soup_.normals[corner.normal]);
        const double length = glm::length(normal);
        if (!(length > 0)) {
            failZeroNormal(polygon);
        }
        return normal / length;
    }
    [[noreturn]] void failZeroNormal(std::size_t polygon) const {
        fail(polygon, "a vertex normal is zero", "export the mesh with valid normals or without any");
    }

    // No ray hits a polygon without area: any direction serves.
    [[nodiscard]] static glm::vec3 flatDirection(const glm::dvec3& area) {
        const double length = glm::length(area);
        return length > 0 ? glm::vec3(area / length) : kAnyDirection;
    }

    PolygonSoup soup_;
    Mesh mesh_;
    bool isSmooth_ = false;
    bool hasUvs_ = false;
    bool numbersMatch_ = false; // every corner's normal and texture coordinates have the number of its position
    std::vector<std::uint32_t> polygon_;
    std::size_t flatPolygons_ = 0;
    std::unordered_map<Vertex, std::uint32_t, VertexHash> indices_;
};

} // namespace

Mesh buildMesh(PolygonSoup soup, const std::string& file) {
    return MeshBuilder(std::move(soup), file).build();
}

void setPositions(Mesh& mesh, std::span<const glm::dvec3> positions) {
    mesh.origin = originOf(positions);
    mesh.positions.reserve(positions.size());
    for (const glm::dvec3& position : positions) {
        mesh.positions.emplace_back(position - mesh.origin);
    }
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
