// Bounds of one mesh under many transforms.
#pragma once

#include "scene/model/scene.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace hyalite {

// The mesh's vertices, sorted into boxes: most boxes lie so far inside that none of their vertices need be transformed.
class MeshExtent {
public:
    explicit MeshExtent(const Mesh& mesh);

    // meshBounds(mesh, objectToWorld), to the bit.
    [[nodiscard]] Bounds under(const glm::dmat4& objectToWorld) const;

private:
    void add(std::size_t cell, const glm::dmat4& objectToWorld, Bounds& box) const;

    std::vector<glm::dvec3> vertices_; // of triangles, each once, cell by cell
    std::vector<std::size_t> ends_;    // of each cell's vertices, which begin where those of the cell before end
    std::vector<double> boxes_;        // of each cell in the mesh's space: centre and half size
    glm::dvec3 farthest_{0};           // coordinates, without their signs
};

} // namespace hyalite
