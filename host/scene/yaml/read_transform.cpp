// See read_transform.h. A new kind of map is a reader here and a row of kMaps.
#include "scene/yaml/read_transform.h"

#include "base/spelling.h"
#include "scene/model/affine.h"
#include "scene/model/scene_limits.h"

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace hyalite {
namespace {

constexpr Range kCoordinate{-kLargestLength, kLargestLength};
constexpr Range kAngle{-1e6, 1e6, true, true, "degrees"};

glm::dmat4 readScale(const Value& value) {
    glm::dvec3 factors(1);
    value.readColor(factors, kCoordinate); // one factor or three
    return glm::scale(glm::dmat4(1), factors);
}

glm::dmat4 readRotate(const Value& value) {
    Reader reader(value);
    glm::dvec3 axis(0);
    double degrees = 0;
    reader.required("axis", axis, kCoordinate);
    reader.required("degrees", degrees, kAngle);
    reader.finish();
    if (!(glm::length(axis) >= kSmallestLength)) {
        reader.require("axis").fail("the axis of a rotation must not be zero");
    }
    return glm::rotate(glm::dmat4(1), glm::radians(degrees), axis);
}

glm::dmat4 readTranslate(const Value& value) {
    glm::dvec3 offset(0);
    value.read(offset, kCoordinate);
    return glm::translate(glm::dmat4(1), offset);
}

glm::dmat4 readMatrix(const Value& value) {
    const std::vector<double> rows = value.numbers(16, kCoordinate);
    const glm::dmat4 matrix = glm::transpose(glm::make_mat4(rows.data())); // glm stores columns
    if (rows[12] != 0 || rows[13] != 0 || rows[14] != 0 || rows[15] != 1) {
        value.fail("the last row of a matrix must be 0, 0, 0, 1", "the 16 numbers are read row by row");
    }
    return matrix;
}

using ReadMap = glm::dmat4 (*)(const Value&);
constexpr std::array<Choice<ReadMap>, 4> kMaps{{
    {"scale", readScale},
    {"rotate", readRotate},
    {"translate", readTranslate},
    {"matrix", readMatrix},
}};

// One item of the list: a map with a single key.
glm::dmat4 readStep(const Value& item) {
    Reader reader(item);
    if (item.node().entries.size() > 1) {
        item.fail("each item of 'transform' holds one key, found " + std::to_string(item.node().entries.size()),
                  "the order of maps matters: write a list, [{scale: 2}, {translate: [0, 1, 0]}]");
    }
    for (const Choice<ReadMap>& map : kMaps) {
        if (const auto value = reader.find(map.name)) {
            const glm::dmat4 matrix = map.meaning(*value);
            if (!isInvertible(matrix)) {
                value->fail("this transform is singular: it has no inverse");
            }
            return matrix;
        }
    }
    reader.finish();
    item.fail("an item of 'transform' is empty", "known: scale, rotate, translate, matrix");
}

} // namespace

glm::dmat4 readTransform(const Value& value, const glm::dmat4& around) {
    glm::dmat4 matrix(1);
    for (const Value& item : value.list()) {
        matrix = readStep(item) * matrix;
    }
    if (!isInvertible(matrix)) {
        value.fail("the transforms together are singular: they have no inverse");
    }
    matrix = around * matrix;
    if (!isInvertible(matrix)) {
        value.fail("combined with the enclosing transforms, this one is singular: it has no inverse");
    }
    const glm::dvec3 offset(matrix[3]);
    if (!(glm::length(offset) <= kLargestLength)) {
        value.fail("the transforms together move the object farther than " + numberText(kLargestLength) + " m");
    }
    return matrix;
}

} // namespace hyalite
