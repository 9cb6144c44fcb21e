// Bounds of quadrics; see quadric.h.
#include "scene/model/quadric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace hyalite {
namespace {

using glm::dmat2;
using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// A symmetric matrix whose determinant is below this, relative to the product of its diagonal, may be singular up to
// rounding: its ellipse or ellipsoid may be unbounded.
constexpr double kSingular = 1e-12;

bool isEllipse(double a, double b, double c) { // a x^2 + 2b xy + c y^2 = 1
    return a > 0 && c > 0 && a * c - b * b > kSingular * a * c;
}

bool isEllipsoid(const dmat3& A) {
    const double diagonal = A[0][0] * A[1][1] * A[2][2];
    return isEllipse(A[0][0], A[0][1], A[1][1]) && A[2][2] > 0 && glm::determinant(A) > kSingular * diagonal;
}

// The cross-sections of {q <= 0} perpendicular to an axis: at s along the axis, (p - c)^T B (p - c) <= k with
// c = c0 + s c1 and k = k0 + 2 k1 s + k2 s^2.
struct Sections {
    dmat2 inverseB;
    dvec2 c0;
    dvec2 c1;
    double k0;
    double k1;
    double k2;

    [[nodiscard]] double k(double s) const { return k0 + s * (2 * k1 + s * k2); }
};

std::optional<Sections> ellipticSections(const QuadricForm& form, int axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const dmat3 A = quadraticPart(form);
    const dvec3 b = linearPart(form);
    if (!isEllipse(A[u][u], A[u][v], A[v][v])) {
        return std::nullopt;
    }
    const dmat2 inverse = glm::inverse(dmat2(A[u][u], A[u][v], A[v][u], A[v][v]));
    const dvec2 b0{b[u], b[v]};
    const dvec2 b1{A[axis][u], A[axis][v]};
    return Sections{.inverseB = inverse,
                    .c0 = -(inverse * b0),
                    .c1 = -(inverse * b1),
                    .k0 = glm::dot(b0, inverse * b0) - form.j,
                    .k1 = glm::dot(b0, inverse * b1) - b[axis],
                    .k2 = glm::dot(b1, inverse * b1) - A[axis][axis]};
}

// Shrinks [low, high] to the part from the first to the last s with k(s) >= 0; empty (low > high) if there is none.
void keepSections(const Sections& sections, double& low, double& high) {
    const auto [k0, k1, k2] = std::array{sections.k0, sections.k1, sections.k2};
    if (k2 == 0) {
        if (k1 > 0) {
            low = std::max(low, -k0 / (2 * k1));
        } else if (k1 < 0) {
            high = std::min(high, -k0 / (2 * k1));
        } else if (k0 < 0) {
            low = kInfinite;
        }
        return;
    }
    const double discriminant = k1 * k1 - k0 * k2;
    if (discriminant <= 0) { // k has the sign of k2, or touches 0
        low = k2 < 0 ? kInfinite : low;
        return;
    }
    const double q = -k1 - std::copysign(std::sqrt(discriminant), k1); // no cancellation
    const double first = std::min(q / k2, k0 / q);
    const double last = std::max(q / k2, k0 / q);
    if (k2 < 0) {
        low = std::max(low, first);
        high = std::min(high, last);
    } else { // there are no sections between the roots
        low = low > first && low < last ? last : low;
        high = high > first && high < last ? first : high;
    }
}

// Shrinks the box if the cross-sections of q are ellipses and the box is bounded along the axis.
void shrinkBySections(const QuadricForm& form, int axis, Bounds& box) {
    const auto sections = ellipticSections(form, axis);
    if (!sections) {
        return;
    }
    double& low = box.low[axis];
    double& high = box.high[axis];
    keepSections(*sections, low, high);
    if (!(low <= high) || !std::isfinite(high - low)) {
        return;
    }
    // k is largest at an end or at its vertex. A box around the centres, grown by the largest section's extent, holds
    // all sections
    double largest = std::max(sections->k(low), sections->k(high));
    if (sections->k2 < 0) {
        largest = std::max(largest, sections->k(std::clamp(-sections->k1 / sections->k2, low, high)));
    }
    const dvec2 reach = glm::sqrt(std::max(largest, 0.0) * dvec2(sections->inverseB[0][0], sections->inverseB[1][1]));
    const dvec2 atLow = sections->c0 + low * sections->c1;
    const dvec2 atHigh = sections->c0 + high * sections->c1;
    Bounds around = Bounds::everything();
    for (int i = 0; i < 2; ++i) {
        around.low[(axis + 1 + i) % 3] = std::min(atLow[i], atHigh[i]) - reach[i];
        around.high[(axis + 1 + i) % 3] = std::max(atLow[i], atHigh[i]) + reach[i];
    }
    box = intersection(box, around);
}

} // namespace

Bounds formBounds(const QuadricForm& q) {
    // About its centre an ellipsoid is p^T A p <= k; its extent along axis i is sqrt(k (A^-1)_ii). Along an axis with a
    // zero row in A and b, q is constant; an ellipse in the other two axes remains.
    dmat3 A = quadraticPart(q);
    const dvec3 b = linearPart(q);
    glm::bvec3 endless(false);
    for (int axis = 0; axis < 3; ++axis) {
        endless[axis] = A[axis] == dvec3(0) && b[axis] == 0;
        if (endless[axis]) {
            A[axis][axis] = 1;
        }
    }
    if (glm::all(endless) || !isEllipsoid(A)) {
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

bool isEmpty(const Bounds& box) {
    return !(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z);
}

Bounds transformed(const Bounds& box, const dmat4& map) {
    Bounds image{dvec3(map[3]), dvec3(map[3])};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const double factor = map[column][row];
            if (factor != 0) { // 0 times an infinite side counts as 0
                image.low[row] += std::min(factor * box.low[column], factor * box.high[column]);
                image.high[row] += std::max(factor * box.low[column], factor * box.high[column]);
            }
        }
    }
    return image;
}

Bounds objectBounds(const Quadric& quadric) {
    Bounds box = intersection(quadric.clip, formBounds(quadric.form));
    for (int axis = 0; axis < 3; ++axis) {
        shrinkBySections(quadric.form, axis, box);
    }
    return box;
}

Bounds worldBounds(const Quadric& quadric) {
    const Bounds box = objectBounds(quadric);
    if (isEmpty(box)) {
        return {};
    }
    // The bounds of a rotated ellipsoid are tighter than those of its rotated box. The form stays about the object's
    // origin, because it loses digits far from its centre.
    const dvec3 origin(quadric.objectToWorld[3]);
    const Bounds turned = formBounds(transformed(quadric.form, dmat4(dmat3(quadric.objectToWorld))));
    return intersection(transformed(box, quadric.objectToWorld), {turned.low + origin, turned.high + origin});
}

Quadric withFiniteClip(Quadric quadric) {
    if (quadric.clip.low == Bounds::everything().low && quadric.clip.high == Bounds::everything().high) {
        return quadric;
    }
    const Bounds box = objectBounds(quadric);
    constexpr double kPadding = 1.0 / 256; // relative to the extent: far above rounding errors
    const dvec3 padding = kPadding * (box.high - box.low);
    for (int axis = 0; axis < 3; ++axis) {
        if (std::isfinite(padding[axis])) {
            quadric.clip.low[axis] = std::max(quadric.clip.low[axis], box.low[axis] - padding[axis]);
            quadric.clip.high[axis] = std::min(quadric.clip.high[axis], box.high[axis] + padding[axis]);
        }
    }
    return quadric;
}

} // namespace hyalite
