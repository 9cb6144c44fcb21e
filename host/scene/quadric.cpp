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

// A box around the part of {q <= 0} between two ends of an axis; everything where q has no ellipses across it.
Bounds sectionBounds(const QuadricForm& form, int axis, double low, double high) {
    if (!(low <= high) || !std::isfinite(high - low)) {
        return Bounds::everything();
    }
    // At s along the axis the section is (p - c)^T B (p - c) <= k with c linear in s and k quadratic. A box around the
    // centres, grown by what the largest k reaches, holds them all.
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const dmat3 A = quadraticPart(form);
    const dvec3 b = linearPart(form);
    const glm::dmat2 B{A[u][u], A[u][v], A[v][u], A[v][v]};
    if (!(B[0][0] > 0 && glm::determinant(B) > 0)) {
        return Bounds::everything();
    }
    const glm::dmat2 inverse = glm::inverse(B);
    const glm::dvec2 b0{b[u], b[v]};
    const glm::dvec2 b1{A[axis][u], A[axis][v]};
    // k = k0 + 2 k1 s + k2 s^2 is largest at an end or, where it is concave, at its vertex.
    const double k0 = glm::dot(b0, inverse * b0) - form.j;
    const double k1 = glm::dot(b0, inverse * b1) - b[axis];
    const double k2 = glm::dot(b1, inverse * b1) - A[axis][axis];
    const auto k = [&](double s) { return k0 + s * (2 * k1 + s * k2); };
    double largest = std::max(k(low), k(high));
    if (k2 < 0) {
        largest = std::max(largest, k(std::clamp(-k1 / k2, low, high)));
    }
    if (largest < 0) {
        return {}; // nothing lies between the ends
    }
    const glm::dvec2 atLow = -(inverse * (b0 + low * b1));
    const glm::dvec2 atHigh = -(inverse * (b0 + high * b1));
    const glm::dvec2 reach = glm::sqrt(largest * glm::dvec2(inverse[0][0], inverse[1][1]));
    Bounds box = Bounds::everything();
    box.low[u] = std::min(atLow.x, atHigh.x) - reach.x;
    box.high[u] = std::max(atLow.x, atHigh.x) + reach.x;
    box.low[v] = std::min(atLow.y, atHigh.y) - reach.y;
    box.high[v] = std::max(atLow.y, atHigh.y) + reach.y;
    return box;
}

} // namespace

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

bool isEmpty(const Bounds& box) {
    return !(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z);
}

Bounds objectBounds(const Quadric& quadric) {
    Bounds box = intersection(quadric.clip, formBounds(quadric.form));
    for (int axis = 0; axis < 3; ++axis) {
        box = intersection(box, sectionBounds(quadric.form, axis, box.low[axis], box.high[axis]));
    }
    return box;
}

Quadric withFiniteClip(Quadric quadric) {
    if (quadric.clip.low == Bounds::everything().low && quadric.clip.high == Bounds::everything().high) {
        return quadric;
    }
    const Bounds box = objectBounds(quadric);
    constexpr double kPadding = 1.0 / 256; // of the extent: far above what rounding can do
    const dvec3 padding = kPadding * (box.high - box.low);
    for (int axis = 0; axis < 3; ++axis) {
        if (std::isfinite(padding[axis])) {
            quadric.clip.low[axis] = std::max(quadric.clip.low[axis], box.low[axis] - padding[axis]);
            quadric.clip.high[axis] = std::min(quadric.clip.high[axis], box.high[axis] + padding[axis]);
        }
    }
    return quadric;
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
