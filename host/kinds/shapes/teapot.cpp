// The Utah teapot as a mesh.
#include "scene/import/teapot.h"
#include "kinds/shapes/place_mesh.h"
#include "kinds/shapes/shape_kinds.h"

#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kLevel{.name = "level",
                        .type = KeyType::WholeNumber,
                        .range = {1, kHighestTeapotLevel},
                        .defaultText = "6",
                        .text = "quads along each side of a patch; 6 makes the 2 256 triangles of the classic model"};
constexpr std::array kKeys{kLevel};

Shape read(Reader& reader, const Surroundings& around) {
    std::uint32_t level = 6;
    readKey(reader, kLevel, level);
    return placedMesh(reader, around, around.meshes.loadTeapot(level));
}

} // namespace

constinit const ShapeKind kTeapotShape{
    .doc = {.type = "teapot",
            .schemaName = "teapot",
            .text = "The Utah teapot from its 32 bicubic patches, each cut into `level` × `level` quads of two "
                    "triangles, with smooth normals: 64 `level`² - 8 `level` triangles. It stands on y = 0 about the y "
                    "axis, 3.15 m high, with its handle towards -x and its spout towards +x, 6.4 m across. Like the "
                    "original it is not closed.",
            .keys = kKeys},
    .read = read,
    .isSolid = false};

} // namespace hyalite::kinds
