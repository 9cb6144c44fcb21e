// What mesh files have in common: positions, normals, texture coordinates, and polygons whose corners index them.
// Turned into a Mesh here, so that triangulation and the treatment of normals are the same for every format.
#pragma once

#include "base/error.h"
#include "scene/model/scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hyalite {

inline constexpr std::uint32_t kNoNormal = 0xffffffffU;
inline constexpr std::uint32_t kNoUv = 0xffffffffU;

struct Corner {
    std::uint32_t position = 0;       // in PolygonSoup::positions
    std::uint32_t normal = kNoNormal; // in PolygonSoup::normals
    std::uint32_t uv = kNoUv;         // in PolygonSoup::uvs
};

struct Polygon {
    std::size_t end = 0; // in PolygonSoup::corners; it begins where the one before ends
    int line = 0;        // in the file; 0: a binary file
};

struct PolygonSoup {
    std::vector<glm::dvec3> positions; // object space [m], finite
    std::vector<glm::vec3> normals;    // of any length
    std::vector<glm::vec2> uvs;        // finite
    std::vector<Corner> corners;       // indices in range
    std::vector<Polygon> polygons;     // three corners or more
};

// Splits every polygon into a fan of triangles and gives every corner one index: where corners carry normals or texture
// coordinates, a position is repeated for each pair of these it is used with. Polygons without normals in a mesh that
// has some stay flat; corners without texture coordinates in a mesh that has some get (0, 0).
// Throws Error(BadInput) at a polygon that no fan covers (it is not convex), at a zero normal, when there is no
// polygon and when there are too many.
[[nodiscard]] Mesh buildMesh(PolygonSoup soup, const std::string& file);

// Sets the positions of a mesh, given in the file's coordinates [m], and its origin (see originNear in recentre.h).
void setPositions(Mesh& mesh, std::span<const glm::dvec3> positions);

// Throws Error(BadInput) for a count of 0, and for one beyond kMostTriangles.
void checkTriangleCount(std::size_t count, const std::string& file);

// Whether the device can hold a coordinate read from a file: it is finite and within the range of lengths.
[[nodiscard]] bool isMeshCoordinate(double value);

// Throws Error(BadInput) for a coordinate that it cannot; the message begins with `of`.
[[noreturn]] void failCoordinate(double value, const SourceLocation& where, const std::string& of);

} // namespace hyalite
