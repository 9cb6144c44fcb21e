// See mesh_library.h.
#include "scene/yaml/mesh_library.h"

#include "scene/import/mesh_import.h"
#include "scene/import/teapot.h"
#include "scene/model/bounds.h"
#include "scene/model/repeated_faces.h"

#include <system_error>

namespace hyalite {
namespace {

// The same key for every spelling of a file's path.
std::filesystem::path keyOf(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::path key = std::filesystem::weakly_canonical(path, error);
    return error ? path.lexically_normal() : key; // the import will report the error
}

} // namespace

std::size_t MeshLibrary::load(const Value& file) {
    const std::filesystem::path path = pathOf(file);
    std::filesystem::path key = keyOf(path);
    if (const auto known = loaded_.find(key); known != loaded_.end()) {
        return known->second;
    }
    add(importMesh(path, file.where()));
    loaded_.emplace(std::move(key), scene_->meshes.size() - 1);
    return scene_->meshes.size() - 1;
}

MeshParts& MeshLibrary::loadParts(const Value& file) {
    const std::filesystem::path path = pathOf(file);
    std::filesystem::path key = keyOf(path);
    if (const auto known = parts_.find(key); known != parts_.end()) {
        return known->second;
    }
    ImportedFile imported = importGltf(path, file.where());
    std::vector<std::string> names(imported.meshes.size()); // of the first part with each mesh
    for (const ImportedPart& part : imported.parts) {
        names[part.mesh] = names[part.mesh].empty() ? part.name : names[part.mesh];
    }
    for (ImportedPart& part : imported.parts) {
        part.mesh += scene_->meshes.size();
    }
    for (std::size_t i = 0; i < imported.meshes.size(); ++i) {
        add(std::move(imported.meshes[i]), names[i]);
    }
    MeshParts parts{std::move(imported.materials), std::move(imported.parts)};
    return parts_.emplace(std::move(key), std::move(parts)).first->second;
}

std::size_t MeshLibrary::loadTeapot(std::uint32_t level) {
    const auto [known, isNew] = teapots_.try_emplace(level, scene_->meshes.size());
    if (isNew) {
        scene_->meshes.push_back(makeTeapot(level));
    }
    return known->second;
}

void MeshLibrary::add(Mesh mesh, const std::string& part) {
    if (const auto repeated = dropRepeatedFaces(mesh)) {
        const std::string first = repeated->line > 0
                                      ? "this face lists a triangle of line " + std::to_string(repeated->lineOfFirst)
                                      : "triangle " + std::to_string(repeated->example.second + 1) + " is triangle " +
                                            std::to_string(repeated->example.first + 1);
        warn(*scene_,
             {WarningKind::RepeatedFaces, SourceLocation{mesh.file, repeated->line, repeated->line > 0 ? 1 : 0},
              (part.empty() ? "" : part + ": ") + first + " again; " + std::to_string(repeated->count) +
                  (repeated->count == 1 ? " repeated triangle is" : " repeated triangles are") + " left out",
              "export every face once"});
    }
    scene_->meshes.push_back(std::move(mesh));
}

const Bounds& MeshLibrary::boundsOf(std::size_t index) {
    const auto [known, isNew] = bounds_.try_emplace(index);
    if (isNew) {
        known->second = meshBounds(at(index), glm::dmat4(1));
    }
    return known->second;
}

} // namespace hyalite
