// See mesh_library.h.
#include "scene/yaml/mesh_library.h"

#include "scene/import/mesh_import.h"
#include "scene/import/teapot.h"
#include "scene/model/bounds.h"

#include <iterator>
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
    meshes_->push_back(importMesh(path, file.where()));
    loaded_.emplace(std::move(key), meshes_->size() - 1);
    return meshes_->size() - 1;
}

MeshParts& MeshLibrary::loadParts(const Value& file) {
    const std::filesystem::path path = pathOf(file);
    std::filesystem::path key = keyOf(path);
    if (const auto known = parts_.find(key); known != parts_.end()) {
        return known->second;
    }
    ImportedFile imported = importGltf(path, file.where());
    for (ImportedPart& part : imported.parts) {
        part.mesh += meshes_->size();
    }
    std::move(imported.meshes.begin(), imported.meshes.end(), std::back_inserter(*meshes_));
    MeshParts parts{std::move(imported.materials), std::move(imported.parts)};
    return parts_.emplace(std::move(key), std::move(parts)).first->second;
}

std::size_t MeshLibrary::loadTeapot(std::uint32_t level) {
    const auto [known, isNew] = teapots_.try_emplace(level, meshes_->size());
    if (isNew) {
        meshes_->push_back(makeTeapot(level));
    }
    return known->second;
}

const Bounds& MeshLibrary::boundsOf(std::size_t index) {
    const auto [known, isNew] = bounds_.try_emplace(index);
    if (isNew) {
        known->second = meshBounds(at(index), glm::dmat4(1));
    }
    return known->second;
}

} // namespace hyalite
