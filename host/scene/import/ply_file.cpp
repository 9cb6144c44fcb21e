// PLY, text and binary of both byte orders: elements `vertex` (x y z, nx ny nz, and texture coordinates, which writers
// call s t, u v or texture_u texture_v) and `face` (vertex_indices, also spelt vertex_index). Other properties and
// elements are skipped.
#include "scene/import/mesh_import.h"
#include "scene/import/ply_body.h"
#include "scene/import/polygon_soup.h"

#include <algorithm>
#include <array>

namespace hyalite {
namespace {

constexpr std::array<std::string_view, 8> kVertexNumbers{"x", "y", "z", "nx", "ny", "nz", "u", "v"};
constexpr std::size_t kNormalRole = 3;
constexpr std::size_t kUvRole = 6;
constexpr std::size_t kNotAsked = kVertexNumbers.size();

// The one name here of a property that has several in files.
std::string_view knownName(std::string_view name) {
    if (name == "s" || name == "texture_u") {
        return "u";
    }
    return name == "t" || name == "texture_v" ? "v" : name;
}

// For each property of the vertex element, which of kVertexNumbers it is.
std::vector<std::size_t> vertexRoles(const PlyElement& vertex, const std::string& file) {
    std::vector<std::size_t> roles;
    std::array<bool, kVertexNumbers.size()> found{};
    for (const PlyProperty& property : vertex.properties) {
        const auto* known = std::find(kVertexNumbers.begin(), kVertexNumbers.end(), knownName(property.name));
        const auto role = static_cast<std::size_t>(known - kVertexNumbers.begin());
        roles.push_back(property.countType ? kNotAsked : role);
        if (roles.back() != kNotAsked) {
            found[role] = true;
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!found[axis]) {
            throw Error(ExitCode::BadInput, SourceLocation{file, 0, 0},
                        "the vertices have no property '" + std::string(kVertexNumbers[axis]) + "'");
        }
    }
    const auto drop = [&](std::size_t first, std::size_t end) {
        std::replace_if(
            roles.begin(), roles.end(), [&](std::size_t role) { return role >= first && role < end; }, kNotAsked);
    };
    if (!(found[3] && found[4] && found[5])) { // an incomplete normal is ignored
        drop(kNormalRole, kUvRole);
    }
    if (!(found[6] && found[7])) {
        drop(kUvRole, kNotAsked);
    }
    return roles;
}

void readVertices(PlyBody& body, const PlyElement& element, const std::string& file, PolygonSoup& soup) {
    const std::vector<std::size_t> roles = vertexRoles(element, file);
    const bool hasNormals = std::find(roles.begin(), roles.end(), kNormalRole) != roles.end();
    const bool hasUvs = std::find(roles.begin(), roles.end(), kUvRole) != roles.end();
    soup.positions.reserve(element.count);
    soup.normals.reserve(hasNormals ? element.count : 0);
    soup.uvs.reserve(hasUvs ? element.count : 0);
    for (std::size_t i = 0; i < element.count; ++i) {
        body.beginElement(element, i);
        std::array<double, kVertexNumbers.size()> values{};
        for (std::size_t k = 0; k < roles.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (roles[k] == kNotAsked) {
                body.skip(property);
            } else {
                const double value = body.number(property.type);
                if (!isMeshCoordinate(value)) {
                    failCoordinate(value, body.where(), body.of());
                }
                values[roles[k]] = value;
            }
        }
        body.endElement();
        soup.positions.emplace_back(values[0], values[1], values[2]);
        if (hasNormals) {
            soup.normals.emplace_back(values[3], values[4], values[5]);
        }
        if (hasUvs) {
            soup.uvs.emplace_back(values[6], values[7]);
        }
    }
}

bool isCornerList(const PlyProperty& property) {
    return property.countType && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void readCorners(PlyBody& body, const PlyProperty& property, std::size_t vertexCount, PolygonSoup& soup) {
    const std::size_t count = body.listCount(property);
    if (count < 3) {
        body.fail("face has " + std::to_string(count) + " corners", "it needs at least 3");
    }
    for (std::size_t k = 0; k < count; ++k) {
        const std::int64_t index = body.whole(property.type);
        if (index < 0 || static_cast<std::uint64_t>(index) >= vertexCount) {
            body.fail("the index " + std::to_string(index) + " of a vertex is out of range",
                      "there are " + std::to_string(vertexCount) + ", counted from 0");
        }
        soup.corners.push_back({static_cast<std::uint32_t>(index), kNoNormal, kNoUv});
    }
}

void readFaces(PlyBody& body, const PlyElement& element, std::size_t vertexCount, const std::string& file,
               PolygonSoup& soup) {
    if (element.count > 0 && std::none_of(element.properties.begin(), element.properties.end(), isCornerList)) {
        throw Error(ExitCode::BadInput, SourceLocation{file, 0, 0}, "the faces have no list 'vertex_indices'");
    }
    soup.polygons.reserve(element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
        body.beginElement(element, i);
        bool hasCorners = false; // both spellings in one file: the first counts
        for (const PlyProperty& property : element.properties) {
            if (!hasCorners && isCornerList(property)) {
                readCorners(body, property, vertexCount, soup);
                hasCorners = true;
            } else {
                body.skip(property);
            }
        }
        body.endElement();
        soup.polygons.push_back({soup.corners.size(), body.line()});
    }
}

void skipElements(PlyBody& body, const PlyElement& element) {
    if (element.properties.empty()) {
        return; // it takes no bytes in the file
    }
    for (std::size_t i = 0; i < element.count; ++i) {
        body.beginElement(element, i);
        for (const PlyProperty& property : element.properties) {
            body.skip(property);
        }
        body.endElement();
    }
}

} // namespace

Mesh parsePly(std::string_view bytes, const std::string& file) {
    const PlyHeader header = parsePlyHeader(bytes, file);
    const auto isVertex = [](const PlyElement& element) { return element.name == "vertex"; };
    const auto vertex = std::find_if(header.elements.begin(), header.elements.end(), isVertex);
    if (vertex == header.elements.end()) {
        throw Error(ExitCode::BadInput, SourceLocation{file, 0, 0}, "the file has no vertices");
    }

    PlyBody body(bytes, header, file);
    PolygonSoup soup;
    for (const PlyElement& element : header.elements) {
        body.checkRoomFor(element);
        if (element.name == "vertex") {
            readVertices(body, element, file, soup);
        } else if (element.name == "face") {
            readFaces(body, element, vertex->count, file, soup);
        } else {
            skipElements(body, element);
        }
    }
    for (Corner& corner : soup.corners) {
        corner.normal = soup.normals.empty() ? kNoNormal : corner.position;
        corner.uv = soup.uvs.empty() ? kNoUv : corner.position;
    }
    return buildMesh(std::move(soup), file);
}

} // namespace hyalite
