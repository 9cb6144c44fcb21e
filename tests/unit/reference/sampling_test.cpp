// The maps of the unit square: points worked out by hand, and moments by the midpoint rule.
#include "reference/lib/sampling.h"

#include "unit/reference/support.h"

#include <cmath>
#include <numbers>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

// Mean of g over the unit square: midpoints of an n x n lattice, error O(1 / n^2) for these smooth maps.
constexpr int kLattice = 500;
constexpr double kLatticeError = 1e-5;

template <typename Function>
auto squareMean(const Function& g) {
    decltype(g(dvec2(0))) sum(0);
    for (int i = 0; i < kLattice; ++i) {
        for (int j = 0; j < kLattice; ++j) {
            sum += g(dvec2((i + 0.5) / kLattice, (j + 0.5) / kLattice));
        }
    }
    return sum / (1.0 * kLattice * kLattice);
}

} // namespace

TEST_CASE("random bits become the number given by their upper 24 bits") {
    CHECK(toUnit(0) == 0);
    CHECK(toUnit(0x80000000U) == 0.5);
    CHECK(toUnit(0xffU) == 0);
    CHECK(toUnit(0xffffffffU) == 1 - 0x1p-24);
}

TEST_CASE("the concentric map takes edges of the square to the circle, its diagonals to diagonals") {
    const double h = std::numbers::sqrt2 / 2;
    const auto check = [](dvec2 uv, dvec2 expected) { checkNear({concentricDisc(uv), 0}, {expected, 0}, 1e-15); };
    check({0.5, 0.5}, {0, 0});
    check({1, 0.5}, {1, 0});
    check({0, 0.5}, {-1, 0});
    check({0.5, 1}, {0, 1});
    check({0.5, 0}, {0, -1});
    check({1, 1}, {h, h});
    check({0, 1}, {-h, h});
    // a = 1/2, b = 1/4: radius 1/2 at angle pi/8
    check({0.75, 0.625}, {0.5 * std::cos(std::numbers::pi / 8), 0.5 * std::sin(std::numbers::pi / 8)});
}

TEST_CASE("the concentric map is uniform on the disc") {
    // Uniform on the unit disc: E[x] = E[y] = E[xy] = 0, E[x^2] = E[y^2] = 1/4.
    const dvec3 first = squareMean([](dvec2 uv) { return dvec3(concentricDisc(uv), 0); });
    checkNear(first, {0, 0, 0}, kLatticeError);
    const dvec3 second = squareMean([](dvec2 uv) {
        const dvec2 p = concentricDisc(uv);
        return dvec3(p.x * p.x, p.y * p.y, p.x * p.y);
    });
    checkNear(second, {0.25, 0.25, 0}, kLatticeError);
}

TEST_CASE("a basis about any normal is orthonormal and right-handed, also about the poles") {
    Random random;
    std::vector<dvec3> normals = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, glm::normalize(dvec3(1e-9, 0, -1))};
    for (int i = 0; i < 1000; ++i) {
        normals.push_back(random.direction());
    }
    for (const dvec3& n : normals) {
        const Basis basis = orthonormalBasis(n);
        CHECK_THAT(glm::length(basis.tangent), WithinAbs(1, 1e-14));
        CHECK_THAT(glm::dot(basis.tangent, n), WithinAbs(0, 1e-14));
        checkNear(glm::cross(n, basis.tangent), basis.bitangent, 1e-14);
    }
}

TEST_CASE("a normal with a negative zero has the same basis as with a positive one") {
    const Basis plus = orthonormalBasis({0, 1, 0.0});
    const Basis minus = orthonormalBasis({0, 1, -0.0});
    CHECK(plus.tangent == minus.tangent);
    CHECK(plus.bitangent == minus.bitangent);
}

TEST_CASE("cosine-distributed directions have the moments of cos / pi") {
    // E[cos] = integral of cos^2 / pi = 2/3; E[cos^2] = 1/2; the tangential mean is 0.
    const dvec3 n = glm::normalize(dvec3(0.3, -0.5, -0.8));
    const double cosine = squareMean([&](dvec2 uv) { return glm::dot(cosineHemisphere(uv, n), n); });
    CHECK_THAT(cosine, WithinAbs(2.0 / 3, 1e-4)); // the square root at the disc's rim costs the lattice digits
    const double cosine2 = squareMean([&](dvec2 uv) { return std::pow(glm::dot(cosineHemisphere(uv, n), n), 2); });
    CHECK_THAT(cosine2, WithinAbs(0.5, kLatticeError));
    checkNear(squareMean([&](dvec2 uv) { return cosineHemisphere(uv, n); }), 2.0 / 3 * n, 1e-4);
}

TEST_CASE("uniform directions have no preferred axis") {
    // E[w] = 0 and E[w_i^2] = 1/3 by symmetry.
    checkNear(squareMean([](dvec2 uv) { return uniformSphere(uv); }), {0, 0, 0}, kLatticeError);
    checkNear(squareMean([](dvec2 uv) { return uniformSphere(uv) * uniformSphere(uv); }), dvec3(1.0 / 3),
              kLatticeError);
}

TEST_CASE("points on a parallelogram are its corner plus the shares of its edges") {
    const Quad quad{.corner = {1, 2, 3}, .edge0 = {4, 0, 0}, .edge1 = {0, 2, 2}};
    checkNear(pointOnQuad({0.25, 0.5}, quad), {2, 3, 4}, 0); // 1 + 4/4, 2 + 2/2, 3 + 2/2
}
