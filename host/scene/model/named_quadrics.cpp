// See named_quadrics.h.
#include "scene/model/named_quadrics.h"

#include "scene/model/quadric.h"

#include <glm/gtc/matrix_transform.hpp>

namespace hyalite {
namespace {

glm::dmat4 alongY(double offset) {
    return glm::translate(glm::dmat4(1), glm::dvec3(0, offset, 0));
}

} // namespace

Quadric boxQuadric(const glm::dvec3& halfSize) {
    return {.form = {.j = -1}, .clip = {-halfSize, halfSize}};
}

Quadric cylinderQuadric(double radius, double height) {
    Quadric cylinder;
    cylinder.form = normalised({.a = 1, .h = 1, .j = -radius * radius});
    cylinder.clip.low.y = -height / 2;
    cylinder.clip.high.y = height / 2;
    cylinder.objectToWorld = alongY(height / 2);
    return withFiniteClip(cylinder);
}

Quadric coneQuadric(double baseRadius, double topRadius, double height) {
    // The radius at y is m + k y, with m the radius of the smaller end: q = x^2 + z^2 - (m + k y)^2.
    const bool isTopSmaller = topRadius < baseRadius;
    const double m = isTopSmaller ? topRadius : baseRadius;
    const double k = (topRadius - baseRadius) / height;
    Quadric cone;
    cone.form = normalised({.a = 1, .e = -k * k, .g = -k * m, .h = 1, .j = -m * m});
    cone.clip.low.y = isTopSmaller ? -height : 0;
    cone.clip.high.y = isTopSmaller ? 0 : height;
    cone.objectToWorld = alongY(isTopSmaller ? height : 0);
    return withFiniteClip(cone);
}

QuadricForm ellipsoidForm(const glm::dvec3& radii) {
    const glm::dvec3 inverse2 = 1.0 / (radii * radii);
    return normalised({.a = inverse2.x, .e = inverse2.y, .h = inverse2.z, .j = -1});
}

QuadricForm paraboloidForm(const glm::dvec3& radii) {
    const glm::dvec3 inverse2 = 1.0 / (radii * radii);
    return normalised({.a = inverse2.x, .g = -0.5 / radii.y, .h = inverse2.z});
}

QuadricForm hyperboloidOneSheetForm(const glm::dvec3& radii) {
    const glm::dvec3 inverse2 = 1.0 / (radii * radii);
    return normalised({.a = inverse2.x, .e = -inverse2.y, .h = inverse2.z, .j = -1});
}

QuadricForm hyperboloidTwoSheetsForm(const glm::dvec3& radii) {
    const glm::dvec3 inverse2 = 1.0 / (radii * radii);
    return normalised({.a = inverse2.x, .e = -inverse2.y, .h = inverse2.z, .j = 1});
}

QuadricForm hyperbolicParaboloidForm(const glm::dvec3& radii) {
    const glm::dvec3 inverse2 = 1.0 / (radii * radii);
    return normalised({.a = -inverse2.x, .g = 0.5 / radii.y, .h = inverse2.z});
}

} // namespace hyalite
