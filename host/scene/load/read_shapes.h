// The scene file's shapes. Spheres, quads, disks and planes come back in world space; the others keep their transform.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/mesh_library.h"
#include "scene/yaml/read_placement.h"
#include "scene/yaml/reader.h"

#include <optional>
#include <vector>

namespace hyalite {

// What a shape is told by what stands around it in the file, and where it puts what it has besides itself.
struct Surroundings {
    Placement placement = {};
    std::optional<std::size_t> material = {};    // of the nearest object or csg that names one
    std::optional<std::size_t> cutMaterial = {}; // set where the shape only cuts: goes before its own material
    Scene& scene;                                // for the leaves of a csg
    MeshLibrary& meshes;
    std::vector<Object>* parts = nullptr; // where a mesh file of several parts puts them; null: they become one mesh
};

// A shape with its own `transform` and `material` applied; not the object's emission. Where `parts` is given and then
// not empty, it holds all of the shape, and what is returned is of no meaning. Throws Error(BadInput).
[[nodiscard]] Object readShape(const Value& value, const Surroundings& around);

} // namespace hyalite
