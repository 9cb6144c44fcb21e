// See object_record.h.
#include "kinds/shapes/object_record.h"

#include <bit>
#include <cmath>

namespace hyalite::kinds {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;
using glm::vec3;
using glm::vec4;

float bits(std::uint32_t value) {
    return std::bit_cast<float>(value);
}

vec4 row(const dmat4& m, int i) {
    return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

ObjectRecord flatRecord(std::uint32_t type, const dvec3& origin, const dvec3& axis0, const dvec3& axis1) {
    const dvec3 cross = glm::cross(axis0, axis1);
    const double area2 = glm::dot(cross, cross);
    const dvec3 u = glm::cross(axis1, cross) / area2;
    const dvec3 v = glm::cross(cross, axis0) / area2;
    const dvec3 normal = cross / std::sqrt(area2);
    ObjectRecord r{.type = type};
    r.texels[0] = vec4(vec3(normal), static_cast<float>(glm::dot(normal, origin)));
    r.texels[1] = vec4(vec3(u), static_cast<float>(-glm::dot(u, origin)));
    r.texels[2] = vec4(vec3(v), static_cast<float>(-glm::dot(v, origin)));
    return r;
}

dvec3 setLocalSpace(ObjectRecord& r, const dmat4& objectToWorld, const dvec3& center) {
    const vec3 origin(objectToWorld * dvec4(center, 1));
    const dmat4 toObject = glm::inverse(objectToWorld);
    for (int i = 0; i < 3; ++i) {
        r.texels[static_cast<std::size_t>(i)] = vec4(vec3(row(toObject, i)), origin[i]);
    }
    return toObject * dvec4(dvec3(origin), 1);
}

} // namespace hyalite::kinds
