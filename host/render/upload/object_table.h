// The scene's objects as the kernels read them, and the hierarchy over them.
#pragma once

#include "render/upload/mesh_tables.h"
#include "scene/model/scene.h"

#include "shaders/shared/limits.h"
#include "shaders/shared/scene_records.h"

#include <cstdint>
#include <vector>

namespace hyalite::render {

// Unbounded objects come first, then the others in the order of the hierarchy's leaves, then the leaves of CSG.
struct ObjectTable {
    std::vector<glm::vec4> texels;
    std::vector<shared::InstanceRecord> instances;
    std::vector<std::uint32_t> objectOf; // scene object of each; for a leaf of CSG, the object it is part of
    std::vector<std::uint32_t> leafOf;   // for a leaf of CSG, its number in Scene::csgLeaves; else kNone
    std::uint32_t endlessCount = 0;
    std::uint32_t rootNode = 0;
    std::uint32_t shapeTypes = 0;   // bit kShape… is set for every type that occurs
    std::uint32_t stackEntries = 0; // most stack entries that a ray needs among the objects
    std::uint32_t mostLeaves = 0;   // most leaves of a CSG object
};

// Appends the hierarchy over the objects and the programs of CSG trees to the geometry. Emitting objects are the lights
// from `firstLight` on.
[[nodiscard]] ObjectTable buildObjectTable(const Scene& scene, const std::vector<std::uint32_t>& meshRoots,
                                           std::uint32_t firstLight, std::vector<glm::uvec4>& geometry);

} // namespace hyalite::render
