// A shape type as one row: its description for the scene file and its reader. Reading gives a Shape, whose device
// record comes from record() (object_record.h) and whose bounds come from worldBounds (scene/model/bounds.h);
// host/reference/shapes intersects it. One file per type or family of types; shape_kinds.h lists them.
#pragma once

#include "kinds/read_key.h"
#include "scene/model/scene.h"
#include "scene/yaml/key_doc.h"
#include "scene/yaml/mesh_library.h"
#include "scene/yaml/read_placement.h"
#include "scene/yaml/reader.h"

#include <array>
#include <optional>
#include <vector>

namespace hyalite::kinds {

// The context of a shape in the file, and where reading it puts CSG leaves, meshes and further parts.
struct Surroundings {
    // Reads a nested shape and applies its own `transform` and `material`.
    Object (*readShape)(const Value& value, const Surroundings& around);
    Placement placement = {};
    std::optional<std::size_t> material = {};    // of the innermost enclosing object or csg that names one
    std::optional<std::size_t> cutMaterial = {}; // set if the shape is subtracted: overrides its own material
    Scene& scene;                                // for the leaves of a csg
    MeshLibrary& meshes;
    std::vector<Object>* parts = nullptr; // receives the parts of a mesh file; null: merge them into one mesh
};

struct ShapeKind {
    MapDoc doc; // without the keys `transform` and `material`, which every shape has

    // Reads the keys of one shape. Spheres, quads, disks and planes are returned in world space. Others are returned
    // about their own centres, where floats are most precise, with an objectToWorld map. Throws Error(BadInput).
    Shape (*read)(Reader& reader, const Surroundings& around) = nullptr;

    bool isSolid = true;     // may be an operand of a csg; for meshes that depends on the file
    bool makesParts = false; // may put several objects into Surroundings::parts
};

// Every shape has these keys.
inline constexpr KeyDoc kShapeTransform{
    .name = "transform",
    .type = KeyType::Other,
    .defaultText = "none",
    .text = "applied to the shape before the transforms of enclosing shapes; the object's comes last",
    .schema = R"({"$ref": "#/$defs/transform"})",
    .typeText = "list"};
inline constexpr KeyDoc kShapeMaterial{.name = "material",
                                       .type = KeyType::Text,
                                       .defaultText =
                                           "that of the nearest enclosing `csg` that has one, else the object's",
                                       .text = "name of one of the `materials`"};
inline constexpr std::array kKeysOfAllShapes{kShapeTransform, kShapeMaterial};

} // namespace hyalite::kinds
