// Triangle meshes from OBJ, PLY, STL and glTF files.
//
// All but glTF (see gltf_import.h) are read by small strict parsers of our own. Libraries were considered
// and rejected: assimp's OBJ and PLY importers have a long record of heap overflows on malformed files (its issues
// 4770, 4925 and 5729, among many), and tinyobjloader, which reads OBJ alone, takes a missing coordinate for 0 and had
// its share (its issue 175). Neither says where in the file a mistake is. Together these formats are a few hundred
// lines.
#pragma once

#include "scene/model/scene.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace hyalite {

// Reads a mesh; the file's ending (.obj, .ply, .stl, .gltf, .glb, in any case) names its format. The parts
// of a glTF file become one mesh. Throws Error(BadInput): at `where` if the file cannot be read, else with the place in
// the mesh file.
[[nodiscard]] Mesh importMesh(const std::filesystem::path& path, const SourceLocation& where);

// The same from bytes in memory; `file` is for messages and Mesh::file.
[[nodiscard]] Mesh parseObj(std::string_view bytes, const std::string& file);
[[nodiscard]] Mesh parsePly(std::string_view bytes, const std::string& file);
[[nodiscard]] Mesh parseStl(std::string_view bytes, const std::string& file);

// Whether the file's ending is one of glTF's: these files may have parts with placements and materials of their own.
[[nodiscard]] bool isGltf(const std::filesystem::path& path);

} // namespace hyalite
