// See quadric.h.
#include "scene/quadric.h"

#include <algorithm>
#include <cmath>

namespace hyalite {
namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

dmat3 quadraticPart(const QuadricForm& q) {
    return {q.a, q.b, q.c, q.b, q.e, q.f, q.c, q.f, q.h};
}

dvec3 linearPart(const QuadricForm& q) {
    return {q.d, q.g, q.i};
}

// Eigenvectors (columns) and eigenvalues of a symmetric matrix by Jacobi's rotations [Golub13, 8.5].
struct Eigensystem {
    dmat3 vectors{1.0};
    dvec3 values{0};
};

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

} // namespace

dmat4 quadricMatrix(const QuadricForm& q) {
    return {q.a, q.b, q.c, q.d, q.b, q.e, q.f, q.g, q.c, q.f, q.h, q.i, q.d, q.g, q.i, q.j};
}

QuadricForm quadricForm(const dmat4& m) {
    return {m[0][0], m[1][0], m[2][0], m[3][0], m[1][1], m[2][1], m[3][1], m[2][2], m[3][2], m[3][3]};
}

QuadricForm transformed(const QuadricForm& form, const dmat4& map) {
    const dmat4 inverse = glm::inverse(map);
    return quadricForm(glm::transpose(inverse) * quadricMatrix(form) * inverse);
}

double evaluate(const QuadricForm& form, const dvec3& point) {
    const dvec3 gradient = quadraticPart(form) * point + 2.0 * linearPart(form);
    return glm::dot(gradient, point) + form.j;
}

dvec3 halfGradient(const QuadricForm& form, const dvec3& point) {
    return quadraticPart(form) * point + linearPart(form);
}

Bounds formBounds(const QuadricForm& q) {
    // About its centre an ellipsoid is p^T A p <= k; along axis i it reaches sqrt(k (A^-1)_ii). A row of zeros in A and
    // b is a direction in which nothing changes; what is left is an ellipse in the other two.
    dmat3 A = quadraticPart(q);
    const dvec3 b = linearPart(q);
    glm::bvec3 endless(false);
    for (int axis = 0; axis < 3; ++axis) {
        endless[axis] = A[axis] == dvec3(0) && b[axis] == 0;
        if (endless[axis]) {
            A[axis][axis] = 1;
        }
    }
    const double minor2 = A[0][0] * A[1][1] - A[0][1] * A[1][0];
    if (glm::all(endless) || !(A[0][0] > 0 && minor2 > 0 && glm::determinant(A) > 0)) {
        return Bounds::everything();
    }
    const dmat3 inverse = glm::inverse(A);
    const dvec3 center = -(inverse * b);
    const double k = glm::dot(b, inverse * b) - q.j;
    Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = endless[axis] ? kInfinite : std::sqrt(std::max(k, 0.0) * inverse[axis][axis]);
        box.low[axis] = center[axis] - reach;
        box.high[axis] = center[axis] + reach;
    }
    return box;
}

Bounds intersection(const Bounds& a, const Bounds& b) {
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

Bounds transformed(const Bounds& box, const dmat4& map) {
    Bounds image{dvec3(map[3]), dvec3(map[3])};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const double factor = map[column][row];
            if (factor != 0) { // zero times an infinite side is nothing
                image.low[row] += std::min(factor * box.low[column], factor * box.high[column]);
                image.high[row] += std::max(factor * box.low[column], factor * box.high[column]);
            }
        }
    }
    return image;
}

Bounds objectBounds(const Quadric& quadric) {
    return intersection(quadric.clip, formBounds(quadric.form));
}

Bounds worldBounds(const Quadric& quadric) {
    // A turned ellipsoid is narrower than the turned box around it.
    return intersection(transformed(objectBounds(quadric), quadric.objectToWorld),
                        formBounds(transformed(quadric.form, quadric.objectToWorld)));
}

dvec3 formCenter(const QuadricForm& form) {
    const Eigensystem e = eigensystem(quadraticPart(form));
    const dvec3 b = glm::transpose(e.vectors) * linearPart(form);
    const dvec3 magnitude = glm::abs(e.values);
    const double largest = std::max({magnitude.x, magnitude.y, magnitude.z});
    constexpr double kZero = 1e-9; // of the largest: an axis of a cylinder or paraboloid, up to rounding
    dvec3 center(0);
    for (int axis = 0; axis < 3; ++axis) {
        if (magnitude[axis] > kZero * largest) {
            center[axis] = -b[axis] / e.values[axis];
        }
    }
    return e.vectors * center;
}

Quadric halfSpace(const Plane& plane) {
    const dvec3 half = 0.5 * plane.normal;
    Quadric solid;
    solid.form = {.d = half.x, .g = half.y, .i = half.z, .j = -glm::dot(plane.normal, plane.point)};
    return solid;
}

} // namespace hyalite
