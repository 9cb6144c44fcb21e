// See gltf_primitive.h.
#include "scene/import/gltf_primitive.h"

#include "scene/import/gltf_accessor.h"
#include "scene/import/polygon_soup.h"

#include <algorithm>
#include <cmath>

namespace hyalite {
namespace {

// How a primitive's corners become triangles, by the format's numbers; below 4 are points and lines.
enum class Mode : std::uint8_t { Triangles = 4, Strip = 5, Fan = 6 };

// Corners that one byte of a file may stand for: an index of a byte makes three corners of a strip, and exporters use
// the same data for a few primitives, but not for thousands.
constexpr std::size_t kMostCornersPerByte = 16;

std::vector<glm::uvec3> makeTriangles(const std::vector<std::uint32_t>& corners, Mode mode) {
    std::vector<glm::uvec3> triangles;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        const glm::uvec3 t(corners[a], corners[b], corners[c]);
        if (t.x != t.y && t.y != t.z && t.z != t.x) {
            triangles.push_back(t);
        }
    };
    const std::size_t step = mode == Mode::Triangles ? 3 : 1;
    triangles.reserve(corners.size() / step);
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
        if (mode == Mode::Fan) {
            add(i + 1, i + 2, 0);
        } else if (mode == Mode::Strip && i % 2 == 1) { // every other triangle is reversed
            add(i, i + 2, i + 1);
        } else {
            add(i, i + 1, i + 2);
        }
    }
    return triangles;
}

// Renumbers the triangles' corners in the order of the vertices that they use; returns those.
std::vector<std::uint32_t> keepUsed(std::vector<glm::uvec3>& triangles) {
    std::uint32_t low = triangles[0].x;
    std::uint32_t high = low;
    for (const glm::uvec3& t : triangles) {
        low = std::min({low, t.x, t.y, t.z});
        high = std::max({high, t.x, t.y, t.z});
    }
    std::vector<std::uint32_t> number(std::size_t{high} - low + 1, 0);
    for (const glm::uvec3& t : triangles) {
        number[t.x - low] = number[t.y - low] = number[t.z - low] = 1;
    }
    std::vector<std::uint32_t> used;
    for (std::uint32_t i = 0; i < number.size(); ++i) {
        if (number[i] != 0) {
            number[i] = static_cast<std::uint32_t>(used.size());
            used.push_back(low + i);
        }
    }
    for (glm::uvec3& t : triangles) {
        t = {number[t.x - low], number[t.y - low], number[t.z - low]};
    }
    return used;
}

// The accessor of an attribute; none where the primitive has none. It must have an element for each position.
std::optional<GltfAccessor> findAttribute(GltfDocument& document, const GltfValue& attributes, const char* name,
                                          std::string_view type, std::size_t vertices) {
    const auto reference = attributes.find(name);
    if (!reference) {
        return std::nullopt;
    }
    GltfAccessor accessor(document, *reference, type);
    if (accessor.size() != vertices) {
        reference->fail("the accessor has " + std::to_string(accessor.size()) + " elements, there are " +
                        std::to_string(vertices) + " positions");
    }
    return accessor;
}

void readPositions(const GltfAccessor& accessor, const std::vector<std::uint32_t>& used, Mesh& mesh) {
    std::vector<glm::dvec3> placed;
    placed.reserve(used.size());
    for (const std::uint32_t vertex : used) {
        glm::dvec3 position;
        for (int axis = 0; axis < 3; ++axis) {
            const double value = accessor.component(vertex, static_cast<std::size_t>(axis));
            if (!isMeshCoordinate(value)) {
                accessor.fail(vertex, std::isfinite(value) ? "the coordinate is too large"
                                                           : "a coordinate is not a finite number");
            }
            position[axis] = value;
        }
        placed.push_back(position);
    }
    setPositions(mesh, placed);
}

void readNormals(const GltfAccessor& accessor, const std::vector<std::uint32_t>& used, Mesh& mesh) {
    mesh.normals.reserve(used.size());
    for (const std::uint32_t vertex : used) {
        const glm::dvec3 normal(accessor.component(vertex, 0), accessor.component(vertex, 1),
                                accessor.component(vertex, 2));
        const double length = glm::length(normal);
        if (!(length > 0 && std::isfinite(length))) {
            accessor.fail(vertex, "the normal is zero or not finite",
                          "export the mesh with valid normals or without any");
        }
        mesh.normals.emplace_back(normal / length);
    }
}

void readTextureCoordinates(const GltfAccessor& accessor, const std::vector<std::uint32_t>& used, Mesh& mesh) {
    mesh.uvs.reserve(used.size());
    for (const std::uint32_t vertex : used) {
        const glm::vec2 uv(accessor.component(vertex, 0), accessor.component(vertex, 1));
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
            accessor.fail(vertex, "a texture coordinate is not a finite number");
        }
        mesh.uvs.emplace_back(uv.x, 1 - uv.y); // the format's v points downwards
    }
}

} // namespace

void GltfPrimitives::countCorners(const GltfValue& primitive, std::size_t count) {
    corners_ += count;
    if (corners_ / kMostCornersPerByte > document_->bytesRead()) {
        primitive.fail("the primitives so far have " + std::to_string(corners_) + " corners in a file of " +
                           std::to_string(document_->bytesRead()) + " bytes",
                       "at most " + std::to_string(kMostCornersPerByte) + " for each byte are read");
    }
}

// The vertices of the primitive's corners, in order.
std::vector<std::uint32_t> GltfPrimitives::readCorners(const GltfValue& primitive, std::size_t vertices) {
    std::vector<std::uint32_t> corners;
    const auto reference = primitive.find("indices");
    if (!reference) {
        countCorners(primitive, vertices);
        corners.resize(vertices);
        for (std::uint32_t i = 0; i < vertices; ++i) {
            corners[i] = i;
        }
        return corners;
    }
    const GltfAccessor indices(*document_, *reference, "SCALAR");
    indices.requireIndices();
    countCorners(primitive, indices.size());
    corners.reserve(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::uint32_t vertex = indices.index(i);
        if (vertex >= vertices) {
            indices.fail(i, "the index " + std::to_string(vertex) + " of a vertex is out of range",
                         "there are " + std::to_string(vertices) + ", counted from 0");
        }
        corners.push_back(vertex);
    }
    return corners;
}

Mesh GltfPrimitives::read(const GltfValue& primitive) {
    Mesh mesh;
    mesh.file = primitive.file();
    const auto mode = primitive.find("mode");
    const std::uint64_t number = mode ? mode->whole(0, 6) : static_cast<std::uint64_t>(Mode::Triangles);
    if (number < static_cast<std::uint64_t>(Mode::Triangles)) {
        return mesh;
    }
    const GltfValue attributes = primitive.require("attributes");
    const GltfAccessor positions(*document_, attributes.require("POSITION"), "VEC3");
    const std::vector<std::uint32_t> corners = readCorners(primitive, positions.size());
    if (static_cast<Mode>(number) == Mode::Triangles && corners.size() % 3 != 0) {
        primitive.fail("its " + std::to_string(corners.size()) + " corners are not a multiple of 3");
    }
    mesh.triangles = makeTriangles(corners, static_cast<Mode>(number));
    if (mesh.triangles.empty()) {
        return mesh;
    }
    checkTriangleCount(mesh.triangles.size(), mesh.file);
    const std::vector<std::uint32_t> used = keepUsed(mesh.triangles);
    readPositions(positions, used, mesh);
    if (const auto normals = findAttribute(*document_, attributes, "NORMAL", "VEC3", positions.size())) {
        readNormals(*normals, used, mesh);
    }
    if (const auto uvs = findAttribute(*document_, attributes, "TEXCOORD_0", "VEC2", positions.size())) {
        readTextureCoordinates(*uvs, used, mesh);
    }
    return mesh;
}

} // namespace hyalite
