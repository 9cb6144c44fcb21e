// The meshes of a scene: each is read or made once, however many objects use it.
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
    std::vector<ImportedPart> parts;                        // their mesh indices are into the scene's meshes
    std::map<std::size_t, std::size_t> sceneMaterials = {}; // index in the file to Scene::materials, of those in use
};

class MeshLibrary {
public:
    // Mesh paths are relative to `folder`; the meshes and warnings about them are added to the scene, which must
    // outlive the library.
    MeshLibrary(std::filesystem::path folder, Scene& scene) : folder_(std::move(folder)), scene_(&scene) {}

    // Index of the mesh in the named file, all its parts merged. Throws Error(BadInput): for an unreadable file, at the
    // place of its name in the scene; for a mistake in the file, at its place in the mesh file.
    [[nodiscard]] std::size_t load(const Value& file);

    // The parts of the named file. Throws like load(). The reference stays valid.
    [[nodiscard]] MeshParts& loadParts(const Value& file);

    // Index of the teapot of this level (see makeTeapot).
    [[nodiscard]] std::size_t loadTeapot(std::uint32_t level);

    [[nodiscard]] const Mesh& at(std::size_t index) const { return scene_->meshes[index]; }

    // Bounds of the mesh in its object space.
    [[nodiscard]] const Bounds& boundsOf(std::size_t index);

private:
    [[nodiscard]] std::filesystem::path pathOf(const Value& file) const { return folder_ / file.text(); }

    // Adds a mesh without the faces that it repeats, which cause a warning; `part` of its file, if not all of it.
    void add(Mesh mesh, const std::string& part = {});

    std::filesystem::path folder_;
    Scene* scene_;
    std::map<std::filesystem::path, std::size_t> loaded_;
    std::map<std::filesystem::path, MeshParts> parts_;
    std::map<std::uint32_t, std::size_t> teapots_; // by level
    std::map<std::size_t, Bounds> bounds_;
};

} // namespace hyalite
