// See mesh_library.h.
#include "scene/mesh_library.h"

#include "scene/mesh_import.h"
#include "scene/teapot.h"

#include <system_error>

namespace hyalite {

std::size_t MeshLibrary::load(const Value& file) {
    const std::filesystem::path path = folder_ / file.text();
    std::error_code error;
    std::filesystem::path key = std::filesystem::weakly_canonical(path, error);
    if (error) {
        key = path.lexically_normal(); // the import will say what is wrong with it
    }
    if (const auto known = loaded_.find(key); known != loaded_.end()) {
        return known->second;
    }
    meshes_->push_back(importMesh(path, file.where()));
    loaded_.emplace(std::move(key), meshes_->size() - 1);
    return meshes_->size() - 1;
}

std::size_t MeshLibrary::loadTeapot(std::uint32_t level) {
    const auto [known, isNew] = teapots_.try_emplace(level, meshes_->size());
    if (isNew) {
        meshes_->push_back(makeTeapot(level));
    }
    return known->second;
}

} // namespace hyalite
