// The scene file's surfaces of second degree, by name or by coefficients, which a box may cut and its faces close.
#pragma once

#include "scene/model/named_quadrics.h"
#include "scene/model/scene.h"
#include "scene/yaml/read_placement.h"
#include "scene/yaml/reader.h"

namespace hyalite {

// The keys of one shape. Throw Error(BadInput).
[[nodiscard]] Shape readQuadric(Reader& reader, const Placement& placement);
[[nodiscard]] Shape readNamedQuadric(Reader& reader, const Placement& placement,
                                     QuadricForm (*formOf)(const glm::dvec3& radii));

template <QuadricForm (*formOf)(const glm::dvec3& radii)>
Shape readNamedQuadric(Reader& reader, const Placement& placement) {
    return readNamedQuadric(reader, placement, formOf);
}

} // namespace hyalite
