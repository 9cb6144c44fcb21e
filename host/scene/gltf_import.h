// glTF 2.0 files (.gltf, .glb): their meshes, where they stand, and what they are made of.
//
// Read are the triangles of the default scene with normals and first texture coordinates, and the factors of the
// metallic-roughness materials. Textures, cameras, lights, animations and points and lines are left; skins, morphed
// shapes and files that require an extension which changes the shape (compression, for one) are errors. The JSON is
// read by nlohmann's library; what it says is followed by our own code, which checks every offset.
#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite {

// The metallic-roughness model's factors; what textures would multiply in is not.
struct ImportedMaterial {
    std::string name;        // may be empty
    glm::dvec3 baseColor{1}; // [0, 1], linear
    double metallic = 1;     // [0, 1]
    double roughness = 1;    // [0, 1]
};

// A mesh in one place.
struct ImportedPart {
    std::size_t mesh = 0;                // in ImportedFile::meshes
    glm::dmat4 toFile{1};                // from the mesh's space to the file's; affine, perhaps without an inverse
    std::optional<std::size_t> material; // in ImportedFile::materials; none: the file names none
    std::string name;                    // for messages: "nodes[3], meshes[1].primitives[0]"
};

struct ImportedFile {
    std::vector<Mesh> meshes; // one for each primitive, shared by the nodes and primitives with the same data
    std::vector<ImportedMaterial> materials;
    std::vector<ImportedPart> parts; // at least one
};

// `where` is for a file that cannot be read. Throws Error(BadInput) with the place in the file's JSON.
[[nodiscard]] ImportedFile importGltf(const std::filesystem::path& path, const SourceLocation& where);

// The same from bytes in memory; buffers in files of their own are looked for in `folder`.
[[nodiscard]] ImportedFile parseGltf(std::string_view bytes, const std::string& file,
                                     const std::filesystem::path& folder);

// All parts as one mesh in the file's space, as CSG wants it; flat parts stay flat. No texture coordinates.
[[nodiscard]] Mesh mergeParts(const ImportedFile& file);

// The same material as a scene has it.
[[nodiscard]] MaterialModel sceneModel(const ImportedMaterial& material);

} // namespace hyalite
