// See mesh_import.h. A new format is a parser in a file of its own and a row of kFormats.
#include "scene/import/mesh_import.h"

#include "base/input_file.h"
#include "base/spelling.h"
#include "scene/import/gltf_import.h"
#include "scene/model/scene_limits.h"

#include <array>

namespace hyalite {
namespace {

struct Format {
    std::string_view ending;
    Mesh (*parse)(std::string_view bytes, const std::string& file);
};

constexpr std::array<Format, 3> kFormats{{{".obj", parseObj}, {".ply", parsePly}, {".stl", parseStl}}};

std::string endingOf(const std::filesystem::path& path) {
    return lowerCase(path.extension().string());
}

} // namespace

bool isGltf(const std::filesystem::path& path) {
    const std::string ending = endingOf(path);
    return ending == ".gltf" || ending == ".glb";
}

Mesh importMesh(const std::filesystem::path& path, const SourceLocation& where) {
    if (isGltf(path)) {
        return mergeParts(importGltf(path, where));
    }
    const std::string ending = endingOf(path);
    for (const Format& format : kFormats) {
        if (format.ending == ending) {
            return format.parse(readInputFile(path, kLargestMeshFile, "mesh", where), path.string());
        }
    }
    throw Error(ExitCode::BadInput, where, "unknown mesh format " + inQuotes(ending),
                "known: .obj, .ply, .stl, .gltf, .glb");
}

} // namespace hyalite
