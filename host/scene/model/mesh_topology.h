// Tests whether a mesh bounds a solid and so has an inside, which CSG needs.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>
#include <optional>

namespace hyalite {

struct OpenEdge {
    glm::vec3 from; // object space [m]; a triangle runs along the edge from here to `to`
    glm::vec3 to;
};

// An edge that triangles run along more often in one direction than in the other; nullopt: the mesh is closed, so every
// point off its surface has a winding number. Equal positions are one vertex; a triangle with two equal corners is
// ignored. A mesh without triangles is closed and encloses nothing.
[[nodiscard]] std::optional<OpenEdge> findOpenEdge(const Mesh& mesh);

// The volume that a closed mesh encloses [m^3]; negative if its triangles face inward.
[[nodiscard]] double signedVolume(const Mesh& mesh);
[[nodiscard]] bool isInsideOut(const Mesh& mesh);

} // namespace hyalite
