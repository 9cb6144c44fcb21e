// See read_shapes.h. A new shape is a reader in a file of its kind and a row of kShapes.
#include "scene/load/read_shapes.h"

#include "kinds/shapes/read_flat_shapes.h"
#include "kinds/shapes/read_quadrics.h"
#include "kinds/shapes/read_solids.h"
#include "scene/load/read_csg.h"
#include "scene/load/read_materials.h"
#include "scene/load/read_meshes.h"
#include "scene/yaml/read_transform.h"

#include <array>

namespace hyalite {
namespace {

// Shapes that need to know no more than where they stand.
template <Shape (*read)(Reader&, const Placement&)>
Shape readPlaced(Reader& reader, const Surroundings& around) {
    return read(reader, around.placement);
}

using ReadShape = Shape (*)(Reader&, const Surroundings&);
constexpr std::array<Choice<ReadShape>, 17> kShapes{{
    {"sphere", readPlaced<readSphere>},
    {"box", readPlaced<readBox>},
    {"cylinder", readPlaced<readCylinder>},
    {"cone", readPlaced<readCone>},
    {"torus", readPlaced<readTorus>},
    {"ellipsoid", readPlaced<readNamedQuadric<ellipsoidForm>>},
    {"paraboloid", readPlaced<readNamedQuadric<paraboloidForm>>},
    {"hyperboloid_one_sheet", readPlaced<readNamedQuadric<hyperboloidOneSheetForm>>},
    {"hyperboloid_two_sheets", readPlaced<readNamedQuadric<hyperboloidTwoSheetsForm>>},
    {"hyperbolic_paraboloid", readPlaced<readNamedQuadric<hyperbolicParaboloidForm>>},
    {"quadric", readPlaced<readQuadric>},
    {"plane", readPlaced<readPlane>},
    {"quad", readPlaced<readQuad>},
    {"disk", readPlaced<readDisk>},
    {"mesh", readMesh},
    {"teapot", readTeapot},
    {"csg", readCsg},
}};

} // namespace

Object readShape(const Value& value, const Surroundings& around) {
    Reader reader(value);
    const auto read = choose<ReadShape>(reader.require("type"), "shape", kShapes);
    Surroundings inner = around;
    inner.parts = read == readMesh ? around.parts : nullptr; // within a csg a mesh file is one solid
    if (const auto transform = reader.find("transform")) {
        inner.placement = {readTransform(*transform, around.placement.objectToWorld), transform};
    }
    if (const auto name = reader.find("material")) {
        inner.material = findMaterial(*name, around.scene);
    }
    Object object;
    object.where = reader.where();
    object.shape = read(reader, inner);
    object.material = around.cutMaterial ? around.cutMaterial : inner.material;
    reader.finish();
    return object;
}

} // namespace hyalite
