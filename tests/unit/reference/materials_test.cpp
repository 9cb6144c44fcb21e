// Reflection, refraction and Fresnel's equations against analytic values.
#include "reference/bsdf/interface.h"

#include "unit/reference/support.h"

#include <cmath>

using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

const dvec3 kUp(0, 1, 0);

dvec3 incident(double angle) {
    return {std::sin(angle), -std::cos(angle), 0};
}

} // namespace

TEST_CASE("a mirror flips the normal component of a direction") {
    checkNear(reflect({0.6, -0.8, 0}, kUp), {0.6, 0.8, 0}, 1e-15);
    // N = (1, 1, 1) / sqrt 3, I = -x: N.I = -1/sqrt 3, R = -x + 2/3 (1, 1, 1)
    checkNear(reflect({-1, 0, 0}, dvec3(1) / std::sqrt(3.0)), {-1.0 / 3, 2.0 / 3, 2.0 / 3}, 1e-15);
}

TEST_CASE("refraction follows Snell's law into the dense medium and back along the same path") {
    for (const double degrees : {0.0, 10.0, 45.0, 80.0, 89.9}) {
        const dvec3 in = incident(glm::radians(degrees));
        const auto inside = refract(in, kUp, 1 / 1.5);
        REQUIRE(inside);
        // n_i sin_i = n_t sin_t, in the plane of incidence, unit
        CHECK_THAT(inside->x, WithinAbs(in.x / 1.5, 1e-15));
        CHECK_THAT(inside->y, WithinAbs(-std::sqrt(1 - in.x * in.x / 2.25), 1e-15));
        CHECK_THAT(inside->z, WithinAbs(0, 1e-15));
        const auto outside = refract(*inside, kUp, 1.5);
        REQUIRE(outside);
        checkNear(*outside, in, 1e-12);
    }
}

TEST_CASE("a ray leaving glass beyond the critical angle is totally reflected") {
    const double critical = std::asin(1 / 1.5);
    CHECK(refract(incident(critical - 1e-6), kUp, 1.5));
    CHECK_FALSE(refract(incident(critical + 1e-6), kUp, 1.5));
    CHECK(fresnelDielectric(std::cos(critical + 1e-6), 1.5) == 1);
    CHECK(fresnelDielectric(std::cos(critical - 1e-6), 1.5) < 1);
}

TEST_CASE("at normal incidence ((n - 1) / (n + 1))^2 is reflected, from either side") {
    for (const double n : {1.1, 1.5, 2.4}) {
        const double expected = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
        CHECK_THAT(fresnelDielectric(1, 1 / n), WithinAbs(expected, 1e-15));
        CHECK_THAT(fresnelDielectric(1, n), WithinAbs(expected, 1e-15));
    }
}

TEST_CASE("at Brewster's angle only the perpendicular half of the light is reflected") {
    // tan B = n: r_p = 0 and r_s = (1 - n^2) / (1 + n^2), hence F = r_s^2 / 2.
    const double n = 1.5;
    const double rs = (1 - n * n) / (1 + n * n);
    CHECK_THAT(fresnelDielectric(std::cos(std::atan(n)), 1 / n), WithinAbs(rs * rs / 2, 1e-15));
}

TEST_CASE("a grazing ray is totally reflected and equal indices reflect nothing") {
    CHECK_THAT(fresnelDielectric(0, 1 / 1.5), WithinAbs(1, 1e-15));
    CHECK_THAT(fresnelDielectric(0.3, 1), WithinAbs(0, 1e-30));
}

TEST_CASE("what is not reflected is transmitted") {
    // Transmittance from its own amplitudes t_s = 2 n_i cos_i / (n_i cos_i + n_t cos_t) and
    // t_p = 2 n_i cos_i / (n_t cos_i + n_i cos_t), each with the factor n_t cos_t / (n_i cos_i) of flux.
    for (const double eta : {1 / 1.5, 1.5, 1 / 2.4}) {
        for (int i = 0; i <= 14; ++i) {
            const double angle = 0.05 * i; // below the critical angle of 1.5, asin(2/3) = 0.7297
            const double ci = std::cos(angle);
            const double ct = std::sqrt(1 - eta * eta * std::sin(angle) * std::sin(angle));
            const double ts = 2 * eta * ci / (eta * ci + ct);
            const double tp = 2 * eta * ci / (ci + eta * ct);
            const double transmitted = ct / (eta * ci) * (ts * ts + tp * tp) / 2;
            CHECK_THAT(fresnelDielectric(ci, eta) + transmitted, WithinAbs(1, 1e-14));
        }
    }
}

TEST_CASE("a shading normal turned away from the ray counts as grazing incidence") {
    CHECK(incidentCosine({0, 1, 0}, kUp) == 0);
    CHECK(incidentCosine({0, -1, 0}, kUp) == 1);
}
