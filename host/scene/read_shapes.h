// The scene file's shapes. Spheres and quads come back in world space; meshes keep their transform.
#pragma once

#include "scene/mesh_library.h"
#include "scene/reader.h"
#include "scene/scene.h"

#include <optional>

namespace hyalite {

// The value of an object's `shape`, placed by its `transform` if it has one. Throws Error(BadInput).
[[nodiscard]] Shape readShape(const Value& value, const std::optional<Value>& transform, MeshLibrary& meshes);

} // namespace hyalite
