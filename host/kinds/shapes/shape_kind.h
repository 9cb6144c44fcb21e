// A type of shape in one row: what it is in the scene file and how it is read. Its records on the device are made by
// the record() of the Shape that reading gives (object_record.h), its bounds by worldBounds (scene/model/bounds.h); the
// reference meets it in host/reference/shapes. One file a type, or a family of types; the list is shape_kinds.h.
#pragma once

#include "kinds/read_key.h"
#include "scene/model/scene.h"
#include "scene/yaml/key_doc.h"
#include "scene/yaml/mesh_library.h"
#include "scene/yaml/read_placement.h"
#include "scene/yaml/reader.h"

#include <optional>
#include <vector>

namespace hyalite::kinds {

// What a shape is told by what stands around it in the file, and where it puts what it has besides itself.
struct Surroundings {
    // Reads a shape within this one, with its own `transform` and `material` applied.
    Object (*readShape)(const Value& value, const Surroundings& around);
    Placement placement = {};
    std::optional<std::size_t> material = {};    // of the nearest object or csg that names one
    std::optional<std::size_t> cutMaterial = {}; // set where the shape only cuts: goes before its own material
    Scene& scene;                                // for the leaves of a csg
    MeshLibrary& meshes;
    std::vector<Object>* parts = nullptr; // where a mesh file of several parts puts them; null: they become one mesh
};

struct ShapeKind {
    MapDoc doc; // without the keys `transform` and `material`, which every shape has

    // The keys of one shape. Spheres, quads, disks and planes come back in world space; the others about their own
    // centres, where the kernels' floats are finest, with the way there in their objectToWorld. Throws Error(BadInput).
    Shape (*read)(Reader& reader, const Surroundings& around) = nullptr;

    bool makesParts = false; // it may put several objects into Surroundings::parts
};

} // namespace hyalite::kinds
