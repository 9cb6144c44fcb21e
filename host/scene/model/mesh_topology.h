// Whether a mesh bounds a solid: only then is there an inside, which CSG asks for.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite {

struct OpenEdge {
    glm::vec3 from; // object space [m], in the direction in which a triangle runs along it
    glm::vec3 to;
};

// An edge that triangles run along more often in one direction than in the other; none: the mesh is closed, and every
// point off it has one winding number. Positions of equal value are one vertex, and triangles with two such corners
// count for nothing. A mesh without triangles is closed and bounds nothing.
[[nodiscard]] std::optional<OpenEdge> findOpenEdge(const Mesh& mesh);

// The volume that the triangles of a closed mesh enclose [m^3]: negative where they face inward.
[[nodiscard]] double signedVolume(const Mesh& mesh);
[[nodiscard]] bool isInsideOut(const Mesh& mesh);

} // namespace hyalite
