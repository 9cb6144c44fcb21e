// Any quadric, given by its coefficients. Device: shaders/shapes/quadric.glsl; reference:
// host/reference/shapes/quadric.cpp.
#include "scene/model/quadric.h"
#include "kinds/shapes/clipped_quadric.h"
#include "kinds/shapes/object_record.h"
#include "kinds/shapes/shape_kinds.h"
#include "scene/model/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace hyalite::kinds {
namespace {

// Limits of a coefficient: their squares and products stay far from the limits of a double.
constexpr double kLargestCoefficient = 1e30;
constexpr double kSmallestCoefficient = 1e-30;
constexpr Range kCoefficient{-kLargestCoefficient, kLargestCoefficient};
constexpr KeyDoc kCoefficients{
    .name = "coefficients",
    .type = KeyType::Other,
    .range = kCoefficient,
    .required = true,
    .text = "a to j of a x² + 2b xy + 2c xz + 2d x + e y² + 2f yz + 2g y + h z² + 2i z + j; inside: ≤ 0",
    .schema =
        R"({"type": "array", "items": {"type": "number", "minimum": -1e30, "maximum": 1e30}, "minItems": 10, "maxItems": 10})",
    .typeText = "ten numbers, a to j",
    .rangeText = "each [-1e30, 1e30], not all 0"};
constexpr std::array kKeys{kCoefficients, kClip, kCaps};

// Stored for an unbounded side of the clip box: beyond kEndless of the kernels under any transform.
constexpr double kNoSide = 3e38;

// The origin for the form in the record: near the middle of its bounds if finite, else near its own origin.
glm::dvec3 localCenter(const Quadric& quadric) {
    const Bounds box = objectBounds(quadric);
    const glm::dvec3 near = isFinite(box) ? 0.5 * (box.low + box.high) : glm::dvec3(0);
    const glm::dvec3 center = near + formCenter(transformed(quadric.form, glm::translate(glm::dmat4(1), -near)));
    // A centre far from the clipped part is no help
    const bool isNear = !isFinite(box) || glm::length(center - near) <= 2 * glm::length(box.high - box.low);
    return isNear ? center : near;
}

// Distance of the world's origin from the surface [m], at least that from `box`, its bounds; for the form, an estimate
// by its slope there.
double originToSurface(const Quadric& quadric, const Bounds& box) {
    const glm::dmat3 toObject = glm::inverse(glm::dmat3(quadric.objectToWorld));
    const glm::dvec3 origin = toObject * -glm::dvec3(quadric.objectToWorld[3]);
    const double slope = 2 * glm::length(halfGradient(quadric.form, origin) * toObject);
    const double value = std::abs(evaluate(quadric.form, origin));
    double nearest = slope > 0 ? value / slope : kNoSide;
    for (int axis = 0; axis < 3; ++axis) {
        const double perMeter = glm::length(glm::dvec3(toObject[0][axis], toObject[1][axis], toObject[2][axis]));
        for (const double side : {quadric.clip.low[axis], quadric.clip.high[axis]}) {
            nearest = std::min(nearest, std::abs(side - origin[axis]) / perMeter);
        }
    }
    const glm::dvec3 toBox = glm::max(glm::max(box.low, -box.high), glm::dvec3(0));
    return std::max(nearest, glm::length(toBox));
}

// The origin of the record's space (object space). Coordinates round in proportion to their distance from it. So where
// the surface passes near the world's origin, much nearer than the shape is large, that origin is taken: a ray there
// must meet the surface to within the rounding of its own coordinates.
glm::dvec3 recordCenter(const Quadric& quadric) {
    constexpr double kMuchNearer = 0.25;
    const glm::dvec3 center = localCenter(quadric);
    const glm::dvec3 inWorld = glm::abs(glm::dvec3(quadric.objectToWorld * glm::dvec4(center, 1)));
    const Bounds box = worldBounds(quadric);
    const double extent = isFinite(box) ? 0.5 * glm::length(box.high - box.low) : 0;
    const double size = std::max({inWorld.x, inWorld.y, inWorld.z, extent});
    const bool passesNear = originToSurface(quadric, box) < kMuchNearer * size;
    return passesNear ? glm::dvec3(glm::inverse(quadric.objectToWorld) * glm::dvec4(0, 0, 0, 1)) : center;
}

Shape read(Reader& reader, const Surroundings& around) {
    const Value written = reader.require(kCoefficients.name);
    const std::vector<double> c = written.numbers(10, kCoefficient);
    const QuadricForm form{c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9]};
    const auto isSmall = [](double coefficient) { return std::abs(coefficient) < kSmallestCoefficient; };
    if (std::all_of(c.begin(), c.end(), isSmall)) {
        written.fail("all coefficients of this quadric are 0");
    }
    if (std::all_of(c.begin(), c.end() - 1, isSmall) && (form.j > 0 || !reader.find(kClip.name))) {
        written.fail("only the last coefficient is not 0: q is constant and has no surface",
                     "the order is a b c d e f g h i j; -1 as the last within a 'clip' makes a box");
    }
    return clipped(reader, written, {.form = normalised(form), .objectToWorld = around.placement.objectToWorld});
}

} // namespace

ObjectRecord record(const Quadric& quadric, ObjectTables& /*tables*/) {
    ObjectRecord r{.type = shared::kShapeQuadric};
    const bool isClipped =
        quadric.clip.low != Bounds::everything().low || quadric.clip.high != Bounds::everything().high;
    if (isClipped && !quadric.capped) {
        r.type |= shared::kShapeOpen;
    }
    const glm::dvec3 origin = setLocalSpace(r, quadric.objectToWorld, recordCenter(quadric));
    const QuadricForm q = transformed(quadric.form, glm::translate(glm::dmat4(1), -origin));
    const glm::dvec3 low = glm::max(quadric.clip.low - origin, glm::dvec3(-kNoSide));
    const glm::dvec3 high = glm::min(quadric.clip.high - origin, glm::dvec3(kNoSide));
    r.texels[4] = glm::dvec4(q.a, q.e, q.h, q.j);
    r.texels[5] = glm::dvec4(q.b, q.c, q.f, low.x);
    r.texels[6] = glm::dvec4(q.d, q.g, q.i, high.x);
    r.texels[7] = glm::dvec4(low.y, high.y, low.z, high.z);
    return r;
}

constinit const ShapeKind kQuadricShape{
    .doc = {.type = "quadric",
            .schemaName = "quadric",
            .text = "Any surface of second degree: inside, q ≤ 0, where\n\nq(x, y, z) = a x² + 2b xy + 2c xz + 2d x + "
                    "e y² + 2f yz + 2g y + h z² + 2i z + j\n\nMind the factors of 2: x² + y² + z² - 2x is `[1, 0, 0, "
                    "-1, 1, 0, 0, 1, 0, 0]`. A positive factor leaves the shape unchanged; a negative one swaps inside "
                    "and outside. q must be below 0 somewhere. It must also be above 0 somewhere, unless capped faces "
                    "give the shape its surface: with -1 as the only nonzero coefficient, the last one, the shape is "
                    "the capped `clip` box. A quadric far from its origin loses digits in its coefficients: define it "
                    "near the origin and move it with a `transform`.",
            .keys = kKeys,
            .rules = kCapsNeedClip},
    .read = read};

} // namespace hyalite::kinds
