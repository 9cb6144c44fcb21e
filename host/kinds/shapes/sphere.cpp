// The sphere; a non-uniform transform makes it a quadric. Device: shaders/shapes/solids.glsl; reference:
// host/reference/shapes/geometry.cpp.
#include "kinds/shapes/object_record.h"
#include "kinds/shapes/shape_kinds.h"
#include "scene/model/bounds.h"
#include "scene/model/named_quadrics.h"
#include "scene/model/quadric.h"
#include "scene/yaml/read_placement.h"

#include <array>
#include <cmath>
#include <optional>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kCenter{.name = "center", .type = KeyType::Vector, .range = kCoordinate, .defaultText = "[0, 0, 0]"};
constexpr KeyDoc kRadius{.name = "radius", .range = kLength, .required = true};
constexpr std::array kKeys{kCenter, kRadius};

// The scale factor of the map if it is uniform; nullopt otherwise.
std::optional<double> uniformScale(const glm::dmat4& matrix) {
    const glm::dmat3 linear(matrix);
    const glm::dmat3 gram = glm::transpose(linear) * linear; // scale^2 times the identity
    const double squared = (gram[0][0] + gram[1][1] + gram[2][2]) / 3;
    constexpr double kTolerance = 1e-9; // relative; products of a few rotations have errors of 1e-15
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            const double expected = column == row ? squared : 0;
            if (!(std::abs(gram[column][row] - expected) <= kTolerance * squared)) {
                return std::nullopt;
            }
        }
    }
    return std::sqrt(squared);
}

Shape read(Reader& reader, const Surroundings& around) {
    Sphere sphere;
    readKey(reader, kCenter, sphere.center);
    readKey(reader, kRadius, sphere.radius);
    checkThickness(around.placement, sphere.radius);

    const auto scale = uniformScale(around.placement.objectToWorld);
    if (!scale) {
        const Quadric ellipsoid{.form = ellipsoidForm(glm::dvec3(sphere.radius)),
                                .objectToWorld = placed(around.placement, sphere.center)};
        checkReach(reader, worldBounds(ellipsoid));
        return ellipsoid;
    }
    sphere.center = transformPoint(around.placement.objectToWorld, sphere.center);
    sphere.radius *= *scale;
    checkReach(reader, worldBounds(sphere));
    return sphere;
}

} // namespace

ObjectRecord record(const Sphere& sphere, ObjectTables& /*tables*/) {
    ObjectRecord r{.type = shared::kShapeSphere};
    r.texels[0] = glm::vec4(glm::vec3(sphere.center), static_cast<float>(sphere.radius));
    r.texels[1].x = static_cast<float>(glm::dot(sphere.center, sphere.center) - sphere.radius * sphere.radius);
    return r;
}

constinit const ShapeKind kSphereShape{
    .doc = {.type = "sphere", .schemaName = "sphere", .text = "The points within `radius` of `center`.", .keys = kKeys},
    .read = read};

} // namespace hyalite::kinds
