// See quadric.h.
#include "reference/shapes/quadric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <utility>

namespace hyalite::reference {

namespace {

using glm::dmat3;
using glm::dvec3;

// A solution of A x = c by elimination with complete pivoting; undetermined unknowns are 0, and equations that
// contradict the others are ignored.
dvec3 solveLoosely(dmat3 A, dvec3 c) {
    constexpr double kZero = 1e-9; // of the largest element: a direction in which q does not curve, up to rounding
    std::array<int, 3> unknowns{0, 1, 2}; // by column
    int rank = 0;
    double largest = 0;
    for (; rank < 3; ++rank) {
        int row = rank;
        int column = rank;
        for (int r = rank; r < 3; ++r) {
            for (int k = rank; k < 3; ++k) {
                if (std::abs(A[k][r]) > std::abs(A[column][row])) {
                    row = r;
                    column = k;
                }
            }
        }
        largest = rank == 0 ? std::abs(A[column][row]) : largest;
        if (std::abs(A[column][row]) <= kZero * largest) {
            break;
        }
        std::swap(A[column], A[rank]);
        std::swap(unknowns.at(static_cast<std::size_t>(column)), unknowns.at(static_cast<std::size_t>(rank)));
        for (int k = 0; k < 3; ++k) {
            std::swap(A[k][row], A[k][rank]);
        }
        std::swap(c[row], c[rank]);
        for (int r = rank + 1; r < 3; ++r) {
            const double factor = A[rank][r] / A[rank][rank];
            for (int k = rank; k < 3; ++k) {
                A[k][r] -= factor * A[k][rank];
            }
            c[r] -= factor * c[rank];
        }
    }
    dvec3 x(0);
    for (int r = rank - 1; r >= 0; --r) {
        double rest = c[r];
        for (int k = r + 1; k < rank; ++k) {
            rest -= A[k][r] * x[unknowns.at(static_cast<std::size_t>(k))];
        }
        x[unknowns.at(static_cast<std::size_t>(r))] = rest / A[r][r];
    }
    return x;
}

// a b - c d, accurate to two ulps, by Kahan's algorithm [Jeannerod13].
double differenceOfProducts(double a, double b, double c, double d) {
    const double cd = c * d;
    return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

struct Range { // of s, closed
    double from = -kInfinite;
    double to = kInfinite;
};

// Where alpha s^2 + 2 beta s + gamma <= 0, ascending.
std::vector<Range> notPositive(double alpha, double beta, double gamma) {
    if (alpha == 0 && beta == 0) {
        return gamma <= 0 ? std::vector<Range>{{}} : std::vector<Range>{};
    }
    const double discriminant = differenceOfProducts(beta, beta, alpha, gamma);
    if (discriminant < 0) {
        return alpha < 0 ? std::vector<Range>{{}} : std::vector<Range>{};
    }
    const double k = -(beta + std::copysign(std::sqrt(discriminant), beta));
    const double small = k == 0 ? 0 : gamma / k; // k = 0: both roots are 0
    if (alpha == 0) {
        return beta > 0 ? std::vector<Range>{{.to = small}} : std::vector<Range>{{.from = small}};
    }
    const auto [first, second] = std::minmax({small, k / alpha});
    if (alpha > 0) {
        return {{first, second}};
    }
    return {{.to = first}, {.from = second}};
}

struct BoxRange {
    Range range;
    std::uint32_t entered = 0; // part numbers of the faces
    std::uint32_t left = 0;
};

BoxRange withinBox(const Bounds& box, const dvec3& origin, const dvec3& direction) {
    BoxRange result;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (!(box.low[axis] <= origin[axis] && origin[axis] <= box.high[axis])) {
                return {.range = {kInfinite, -kInfinite}};
            }
            continue;
        }
        double near = (box.low[axis] - origin[axis]) / direction[axis];
        double far = (box.high[axis] - origin[axis]) / direction[axis];
        auto nearPart = static_cast<std::uint32_t>(1 + 2 * axis);
        auto farPart = nearPart + 1;
        if (near > far) {
            std::swap(near, far);
            std::swap(nearPart, farPart);
        }
        if (near > result.range.from) {
            result.range.from = near;
            result.entered = nearPart;
        }
        if (far < result.range.to) {
            result.range.to = far;
            result.left = farPart;
        }
    }
    return result;
}

// Steps along the gradient onto the surface of q. Where the gradient vanishes (the apex of a cone), the curvature
// limits the step.
dvec3 ontoSurface(const WorldQuadric& quadric, dvec3 y) {
    constexpr int kSteps = 2; // the start is off by rounding only, and Newton's method converges quadratically
    const double curvature = frobeniusNorm(quadric.A);
    for (int step = 0; step < kSteps; ++step) {
        const double q = quadric.value(y);
        const dvec3 h = quadric.halfGradient(y);
        const double slope = 2 * glm::length(h);
        if (slope > 0 && std::abs(q) * curvature < slope * slope) {
            y -= q / (slope * slope) * (2.0 * h);
        }
    }
    return y;
}

// Bound on the error in the computed surface of q due to rounding of q itself: dq / |grad q|, limited by sqrt(dq /
// curvature), which holds where the gradient vanishes.
double formOffset(const WorldQuadric& quadric, const dvec3& y) {
    const double reach = glm::length(y);
    const double curvature = frobeniusNorm(quadric.A);
    const double terms = curvature * reach * reach + 2 * glm::length(quadric.b) * reach + std::abs(quadric.j);
    const double byGradient = surfaceOffset(terms) / (2 * glm::length(quadric.halfGradient(y)));
    const double byCurvature = std::sqrt(surfaceOffset(terms) / curvature);
    return std::isnan(byGradient) ? 0 : std::min(byGradient, byCurvature);
}

dvec3 unitOr(const dvec3& v, const dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 0 ? v / length : otherwise;
}

} // namespace

WorldQuadric::WorldQuadric(const Quadric& quadric)
    : clip(quadric.clip), open(!quadric.capped && (glm::any(glm::greaterThan(clip.low, dvec3(-kInfinite))) ||
                                                   glm::any(glm::lessThan(clip.high, dvec3(kInfinite))))) {
    const QuadricForm& q = quadric.form;
    const dmat3 objectA{q.a, q.b, q.c, q.b, q.e, q.f, q.c, q.f, q.h};
    const dvec3 objectB{q.d, q.g, q.i};
    const Affine map(quadric.objectToWorld);
    const auto valueAt = [&](const dvec3& p) { return glm::dot(p, objectA * p + 2.0 * objectB) + q.j; };
    // A point where the terms of q are small: the centre of an ellipsoid, the apex of a cone. For a near-paraboloid
    // that point lies far from the surface, so it is clamped to the clip box.
    const dvec3 middle = glm::clamp(solveLoosely(objectA, -objectB), clip.low, clip.high);
    const dvec3 origin = glm::clamp(dvec3(0), clip.low, clip.high);
    objectCenter = std::abs(valueAt(middle)) <= std::abs(valueAt(origin)) ? middle : origin;
    center = map.pointToWorld(objectCenter);
    toObject = map.inverse;
    A = glm::transpose(toObject) * objectA * toObject;
    b = glm::transpose(toObject) * (objectA * objectCenter + objectB);
    j = valueAt(objectCenter);
}

Crossings crossings(const WorldQuadric& quadric, const Ray& line) {
    // s is measured from the line's point nearest to the centre, which keeps precision for a ray from far away.
    const dvec3 f = line.origin - quadric.center;
    const double start = -glm::dot(f, line.direction);
    const dvec3 nearest = f + start * line.direction;
    const BoxRange box = withinBox(quadric.clip, quadric.objectPoint(nearest), quadric.toObject * line.direction);
    const double alpha = glm::dot(line.direction, quadric.A * line.direction);
    const double beta = glm::dot(line.direction, quadric.halfGradient(nearest));
    Crossings result;
    const auto add = [&](double s, std::uint32_t part, bool entering) {
        result.push_back({.at = {.t = s + start, .part = part}, .entering = entering});
    };
    for (const Range& inside : notPositive(alpha, beta, quadric.value(nearest))) {
        if (quadric.open) {
            for (const bool entering : {true, false}) {
                const double s = entering ? inside.from : inside.to;
                if (std::isfinite(s) && box.range.from <= s && s <= box.range.to) {
                    add(s, 0, entering);
                }
            }
            continue;
        }
        const bool fromBox = box.range.from > inside.from;
        const bool toBox = box.range.to < inside.to;
        const double from = fromBox ? box.range.from : inside.from;
        const double to = toBox ? box.range.to : inside.to;
        if (from <= to) {
            add(from, fromBox ? box.entered : 0, true);
            add(to, toBox ? box.left : 0, false);
        }
    }
    return result;
}

bool isInside(const WorldQuadric& quadric, const dvec3& point) {
    const dvec3 y = point - quadric.center;
    const dvec3 p = quadric.objectPoint(y);
    return !quadric.open && quadric.value(y) <= 0 && glm::all(glm::lessThanEqual(quadric.clip.low, p)) &&
           glm::all(glm::lessThanEqual(p, quadric.clip.high));
}

SurfacePoint surfaceAt(const WorldQuadric& quadric, const Ray& ray, const ShapeHit& hit) {
    dvec3 y = (ray.origin - quadric.center) + hit.t * ray.direction;
    SurfacePoint point{};
    double shapeOffset = 0;
    if (hit.part == 0) {
        y = ontoSurface(quadric, y);
        // At the apex of a cone the gradient vanishes: use the side of the ray.
        point.geometricNormal = unitOr(quadric.halfGradient(y), -ray.direction);
        shapeOffset = formOffset(quadric, y);
    } else {
        const int axis = static_cast<int>(hit.part - 1) / 2;
        const bool high = hit.part % 2 == 0;
        const double face = high ? quadric.clip.high[axis] : quadric.clip.low[axis];
        const dvec3 row = glm::row(quadric.toObject, axis); // the coordinate's gradient in the world
        y -= (quadric.objectPoint(y)[axis] - face) / glm::dot(row, row) * row;
        point.geometricNormal = (high ? 1.0 : -1.0) * glm::normalize(row);
        shapeOffset = surfaceOffset((std::abs(quadric.objectCenter[axis]) + std::abs(face)) / glm::length(row));
    }
    point.normal = point.geometricNormal;
    point.position = quadric.center + y;
    point.offset = shapeOffset + surfaceOffset(glm::length(quadric.center) + glm::length(y));
    return point;
}

} // namespace hyalite::reference
