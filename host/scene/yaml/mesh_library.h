// The meshes that a scene names: each is read or made once, however many objects show it.
#pragma once

#include "scene/import/gltf_import.h"
#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

#include <cstdint>
#include <filesystem>
#include <map>

namespace hyalite {

// A file of several meshes, each in its place.
struct MeshParts {
    std::vector<ImportedMaterial> materials;
    std::vector<ImportedPart> parts;                        // their meshes are those of the scene
    std::map<std::size_t, std::size_t> sceneMaterials = {}; // by the file's number, in Scene::materials; those in use
};

class MeshLibrary {
public:
    // Mesh paths are relative to `folder`; the meshes are put into `meshes`, which must outlive the library.
    MeshLibrary(std::filesystem::path folder, std::vector<Mesh>& meshes)
        : folder_(std::move(folder)), meshes_(&meshes) {}

    // Index of the mesh that the text `file` names, all its parts in one. Throws Error(BadInput): a file that cannot be
    // read at the text's place, a mistake in it at its place in the mesh file.
    [[nodiscard]] std::size_t load(const Value& file);

    // The parts of the file; likewise. The reference stays valid.
    [[nodiscard]] MeshParts& loadParts(const Value& file);

    // Index of the teapot of this level (see makeTeapot).
    [[nodiscard]] std::size_t loadTeapot(std::uint32_t level);

    [[nodiscard]] const Mesh& at(std::size_t index) const { return (*meshes_)[index]; }

    // Of the mesh in its own space.
    [[nodiscard]] const Bounds& boundsOf(std::size_t index);

private:
    [[nodiscard]] std::filesystem::path pathOf(const Value& file) const { return folder_ / file.text(); }

    std::filesystem::path folder_;
    std::vector<Mesh>* meshes_;
    std::map<std::filesystem::path, std::size_t> loaded_;
    std::map<std::filesystem::path, MeshParts> parts_;
    std::map<std::uint32_t, std::size_t> teapots_; // by level
    std::map<std::size_t, Bounds> bounds_;
};

} // namespace hyalite
