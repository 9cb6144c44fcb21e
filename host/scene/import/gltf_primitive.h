// One primitive of a glTF mesh: triangles, strips or fans with their positions, normals and texture coordinates.
#pragma once

#include "scene/import/gltf_document.h"
#include "scene/model/scene.h"

namespace hyalite {

class GltfPrimitives {
public:
    explicit GltfPrimitives(GltfDocument& document) : document_(&document) {}

    // The triangles of the primitive, with the vertices that they use; none for points and lines, which show no
    // surface. Triangles with two equal corners, which strips are sewn together with, are left out.
    // Throws Error(BadInput), also when primitives that share their data ask for far more than the file holds.
    [[nodiscard]] Mesh read(const GltfValue& primitive);

private:
    [[nodiscard]] std::vector<std::uint32_t> readCorners(const GltfValue& primitive, std::size_t vertices);
    void countCorners(const GltfValue& primitive, std::size_t count);

    GltfDocument* document_;
    std::size_t corners_ = 0; // of all primitives so far
};

} // namespace hyalite
