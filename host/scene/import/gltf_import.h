// glTF 2.0 files (.gltf, .glb): their meshes, placements and materials.
//
// Read are the triangles of the default scene with normals and first texture coordinates, and the metallic-roughness
// materials with their textures. Cameras, lights, animations, points and lines are skipped; skins, morphed
// shapes and files that require an extension which changes the shape (compression, for one) are errors. The JSON is
// parsed by nlohmann's library; our own code follows its references and checks every offset.
#pragma once

#include "scene/model/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite {

// Where a texture's image is: a file of its own, or bytes of the glTF file. It is read when a material that uses it is
// first needed.
struct ImportedTexture {
    std::string place;          // for messages: "textures[2]"
    std::filesystem::path file; // empty: `bytes` are the image
    std::string bytes;
    std::string refusal; // why it cannot be shown; empty: it can
};

// The metallic-roughness model; the textures multiply the factors.
struct ImportedMaterial {
    std::string name;                                             // may be empty
    glm::dvec3 baseColor{1};                                      // [0, 1], linear
    double metallic = 1;                                          // [0, 1]
    double roughness = 1;                                         // [0, 1]
    std::optional<ImportedTexture> baseColorTexture = {};         // sRGB
    std::optional<ImportedTexture> metallicRoughnessTexture = {}; // linear; green: roughness, blue: metallic
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

// All parts as one mesh in the file's space, as CSG wants it; flat parts stay flat. No texture coordinates. Throws
// Error(BadInput) where a part's transforms have no inverse.
[[nodiscard]] Mesh mergeParts(const ImportedFile& file);

// The same material as a scene has it.
[[nodiscard]] MaterialModel sceneModel(const ImportedMaterial& material);

} // namespace hyalite
