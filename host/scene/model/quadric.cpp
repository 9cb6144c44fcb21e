// See quadric.h.
#include "scene/model/quadric.h"

#include <algorithm>
#include <cmath>

namespace hyalite {
namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

} // namespace

dmat3 quadraticPart(const QuadricForm& q) {
    return {q.a, q.b, q.c, q.b, q.e, q.f, q.c, q.f, q.h};
}

dvec3 linearPart(const QuadricForm& q) {
    return {q.d, q.g, q.i};
}

dmat4 quadricMatrix(const QuadricForm& q) {
    return {q.a, q.b, q.c, q.d, q.b, q.e, q.f, q.g, q.c, q.f, q.h, q.i, q.d, q.g, q.i, q.j};
}

QuadricForm quadricForm(const dmat4& m) {
    return {m[0][0], m[1][0], m[2][0], m[3][0], m[1][1], m[2][1], m[3][1], m[2][2], m[3][2], m[3][3]};
}

// By Jacobi's rotations [Golub13, 8.5].
Eigensystem eigensystem(dmat3 m) {
    Eigensystem result;
    constexpr int kSweeps = 32; // a handful suffice: convergence is quadratic
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        for (int p = 0; p < 2; ++p) {
            for (int q = p + 1; q < 3; ++q) {
                if (m[p][q] == 0) {
                    continue;
                }
                const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
                const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(1.0, theta));
                const double c = 1 / std::hypot(1.0, t);
                dmat3 rotation(1.0);
                rotation[p][p] = c;
                rotation[q][q] = c;
                rotation[q][p] = t * c;
                rotation[p][q] = -t * c;
                m = glm::transpose(rotation) * m * rotation;
                m[p][q] = 0;
                m[q][p] = 0;
                result.vectors = result.vectors * rotation;
            }
        }
    }
    result.values = {m[0][0], m[1][1], m[2][2]};
    return result;
}

QuadricForm transformed(const QuadricForm& form, const dmat4& map) {
    const dmat4 inverse = glm::inverse(map);
    return quadricForm(glm::transpose(inverse) * quadricMatrix(form) * inverse);
}

QuadricForm normalised(const QuadricForm& q) {
    const double largest = std::max({std::abs(q.a), std::abs(q.b), std::abs(q.c), std::abs(q.d), std::abs(q.e),
                                     std::abs(q.f), std::abs(q.g), std::abs(q.h), std::abs(q.i), std::abs(q.j)});
    return quadricForm(quadricMatrix(q) / largest);
}

double evaluate(const QuadricForm& form, const dvec3& point) {
    const dvec3 gradient = quadraticPart(form) * point + 2.0 * linearPart(form);
    return glm::dot(gradient, point) + form.j;
}

dvec3 halfGradient(const QuadricForm& form, const dvec3& point) {
    return quadraticPart(form) * point + linearPart(form);
}

dvec3 formCenter(const QuadricForm& form) {
    // Along eigenvectors q is a sum of terms v s^2 + 2 b s, each with its extremum at -b / v. If v is 0, the term is 0
    // or, for nonzero b, linear: then the vertex is where q is 0.
    const Eigensystem e = eigensystem(quadraticPart(form));
    const dvec3 b = glm::transpose(e.vectors) * linearPart(form);
    const dvec3 magnitude = glm::abs(e.values);
    const double largest = std::max({magnitude.x, magnitude.y, magnitude.z});
    constexpr double kZero = 1e-9; // relative to the largest: the axis of a cylinder or paraboloid, up to rounding
    dvec3 center(0);
    dvec3 slope(0);
    for (int axis = 0; axis < 3; ++axis) {
        if (magnitude[axis] > kZero * largest) {
            center[axis] = -b[axis] / e.values[axis];
        } else if (std::abs(b[axis]) > kZero * glm::length(b)) {
            slope[axis] = b[axis];
        }
    }
    center = e.vectors * center;
    const double slope2 = glm::dot(slope, slope);
    if (slope2 > 0) { // a step of `slope` changes q by 2 |slope|^2
        center -= e.vectors * slope * (evaluate(form, center) / (2 * slope2));
    }
    return center;
}

Extremes extremes(const QuadricForm& form, const Bounds& finite) {
    // The extremes of q lie where its derivatives along the box, one of its faces, edges or corners vanish, at a unique
    // point inside that part. The 27 parts: along each axis, the low end, the high end or free.
    const dmat3 A = quadraticPart(form);
    const dvec3 b = linearPart(form);
    Extremes result{kInfinite, -kInfinite};
    for (int part = 0; part < 27; ++part) {
        dmat3 rows = glm::transpose(A);
        dvec3 right = -b;
        for (int axis = 0, digits = part; axis < 3; ++axis, digits /= 3) {
            if (digits % 3 != 2) {
                rows[axis] = dmat3(1)[axis];
                right[axis] = digits % 3 == 0 ? finite.low[axis] : finite.high[axis];
            }
        }
        const double determinant = glm::determinant(rows);
        const dvec3 point = glm::inverse(glm::transpose(rows)) * right;
        const bool isInside = glm::all(glm::greaterThanEqual(point, finite.low)) && //
                              glm::all(glm::lessThanEqual(point, finite.high));
        if (determinant != 0 && isInside) {
            const double q = evaluate(form, point);
            result = {std::min(result.least, q), std::max(result.greatest, q)};
        }
    }
    return result;
}

Quadric halfSpace(const Plane& plane) {
    const dvec3 half = 0.5 * plane.normal;
    Quadric solid;
    solid.form = {.d = half.x, .g = half.y, .i = half.z, .j = -glm::dot(plane.normal, plane.point)};
    return solid;
}

} // namespace hyalite
