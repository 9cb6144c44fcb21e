// The sky by day against the formulas of its paper [Preetham99], and the environment that the scene file's `sky`
// becomes.
#include "kinds/lights/sky_model.h"
#include "unit/scene/scene_test_support.h"

#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace hyalite;
using namespace hyalite::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using glm::dvec3;
using std::numbers::pi;

namespace {

// Of linear sRGB, in cd/m^2 or lx.
double luminance(const dvec3& rgb) {
    return kinds::kWhiteEfficacy * glm::dot(dvec3(0.2126, 0.7152, 0.0722), rgb);
}

dvec3 sunAt(double degreesFromZenith, double azimuth = 0.4) {
    const double theta = glm::radians(degreesFromZenith);
    return {std::sin(theta) * std::cos(azimuth), std::cos(theta), std::sin(theta) * std::sin(azimuth)};
}

// The scene of a sky with these keys and the sun 60 degrees from the zenith.
Scene underSky(const std::string& keys) {
    const dvec3 sun = sunAt(60);
    TemporaryFolder folder;
    const std::string text = "hyalite: 1\nlights:\n  - {type: sky, sun: [" + std::to_string(sun.x) + ", " +
                             std::to_string(sun.y) + ", " + std::to_string(sun.z) + "]" + keys +
                             "}\nmaterials: {white: {type: diffuse}}\n"
                             "objects:\n  - {shape: {type: sphere, radius: 1}, material: white}\n";
    return loadScene(folder.write("scene.yaml", text));
}

struct Texel {
    dvec3 direction;   // through its middle
    double solidAngle; // [sr]
    dvec3 radiance;    // [W/(m^2 sr)]
};

// As docs/scene-format.md has it: azimuth from left to right, the middle seen along -z, the right quarter along +x.
std::vector<Texel> texelsOf(const Environment& environment) {
    const Image& image = environment.image;
    std::vector<Texel> texels;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double azimuth = 2 * pi * ((x + 0.5) / image.width - 0.5); // from -z towards +x
            const double theta = pi * (y + 0.5) / image.height;
            texels.push_back(
                {{std::sin(theta) * std::sin(azimuth), std::cos(theta), -std::sin(theta) * std::cos(azimuth)},
                 2 * pi / image.width * (std::cos(pi * y / image.height) - std::cos(pi * (y + 1) / image.height)),
                 environment.scale * dvec3(image.at(x, y))});
        }
    }
    return texels;
}

// Excess of the texels of `lit` over those of `dark`: its irradiance on surfaces facing each texel, and where it comes
// from.
std::pair<dvec3, dvec3> sunOf(const Scene& lit, const Scene& dark) {
    const auto with = texelsOf(*lit.environment);
    const auto without = texelsOf(*dark.environment);
    dvec3 irradiance(0);
    dvec3 from(0);
    for (std::size_t i = 0; i < with.size(); ++i) {
        if (with[i].direction.y > 0) { // the ground has its own share of the sun
            const dvec3 more = with[i].solidAngle * (with[i].radiance - without[i].radiance);
            irradiance += more;
            from += more.y * with[i].direction;
        }
    }
    return {irradiance, glm::normalize(from)};
}

} // namespace

TEST_CASE("the zenith of the sky has the luminance of the paper's formula") {
    // T = 3, 60 degrees: chi = (4/9 - 3/120) (pi - 2 pi / 3) = 0.439241, tan chi = 0.469855;
    // (4.0453 * 3 - 4.9710) * 0.469855 - 0.2155 * 3 + 2.4192 = 5.13916 kcd/m^2
    const double expected = 5.13916;
    CHECK_THAT(kinds::zenithLuminance(3, glm::radians(60.0)), WithinRel(expected, 1e-5));
    const kinds::SkyModel sky(3, sunAt(60));
    CHECK_THAT(sky.chromaticityAndLuminance({0, 1, 0}).z, WithinRel(1000 * expected, 1e-5));
    // By the rows of the matrix to sRGB, rounded to four digits
    CHECK_THAT(luminance(sky.radiance({0, 1, 0})), WithinRel(1000 * expected, 1e-3));
    // Texels of the uppermost row are half a row from it
    const Scene scene = underSky(", sun_scale: 0, resolution: 1024");
    CHECK_THAT(luminance(dvec3(scene.environment->image.at(100, 0))), WithinRel(1000 * expected, 5e-3));
}

TEST_CASE("the sky is brightest and whitest about the sun, and deep blue across from it") {
    const dvec3 sun = sunAt(60);
    const kinds::SkyModel sky(2.5, sun);
    const dvec3 near = sky.chromaticityAndLuminance(sun);
    const dvec3 across = sky.chromaticityAndLuminance(glm::normalize(dvec3(-sun.x, 1.2, -sun.z)));
    CHECK(near.z > 4 * across.z);
    CHECK(near.x > across.x + 0.03);
    CHECK(across.x < 0.26); // daylight of D65 has x = 0.3127
}

TEST_CASE("the ground below a sky reflects the irradiance given by a quadrature of the model") {
    const kinds::SkyModel sky(4, sunAt(60));
    constexpr int kSteps = 200;
    dvec3 irradiance(
        0); // midpoints in cos^2 and in azimuth: the integral of L cos over the hemisphere is pi times the mean
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = std::sqrt((i + 0.5) / kSteps);
        const double sine = std::sqrt(1 - cosine * cosine);
        for (int j = 0; j < 2 * kSteps; ++j) {
            const double phi = pi * (j + 0.5) / kSteps;
            irradiance += sky.radiance({sine * std::cos(phi), cosine, sine * std::sin(phi)});
        }
    }
    irradiance *= pi / (2 * kSteps * kSteps);
    const double sunAbove = 0.5; // cosine of 60 degrees
    const dvec3 sun = kinds::sunIrradiance(4, kinds::relativeAirMass(glm::radians(60.0)));
    for (const double sunScale : {0.0, 2.0}) {
        const Scene scene =
            underSky(", turbidity: 4, ground_albedo: [0.1, 0.2, 0.4], sun_scale: " + std::to_string(sunScale));
        const dvec3 ground(scene.environment->image.at(7, 511));
        const dvec3 expected = dvec3(0.1, 0.2, 0.4) * (irradiance + sunScale * sunAbove * sun) / pi;
        for (int channel = 0; channel < 3; ++channel) {
            CHECK_THAT(ground[channel], WithinRel(expected[channel], 2e-3));
        }
    }
    // Some ten thousand lx without the sun
    CHECK(luminance(irradiance) > 8e3);
    CHECK(luminance(irradiance) < 35e3);
}

TEST_CASE("the sun above the air has the solar illuminance constant, and its light reddens on its way down") {
    // 133 klx measured; a black body with the sun's power has less of it in the green, 92 lm/W: 1361 W/m^2 give 125 klx
    CHECK_THAT(luminance(kinds::sunIrradiance(3, 0)), WithinRel(133e3, 0.07));
    CHECK_THAT(luminance(kinds::sunIrradiance(3, 0)), WithinRel(1361 * 92.0, 0.01));
    CHECK_THAT(kinds::relativeAirMass(0), WithinRel(1.0, 1e-3));
    // 1 / (0 + 0.15 * 3.885^-1.253) = 36.51 atmospheres at the horizon
    CHECK_THAT(kinds::relativeAirMass(pi / 2), WithinRel(36.51, 1e-3));
    const dvec3 high = kinds::sunIrradiance(3, 1);
    const dvec3 low = kinds::sunIrradiance(3, 10);
    CHECK(high.z / high.x > 2 * low.z / low.x);
    CHECK(luminance(high) > 3 * luminance(low));
}

TEST_CASE("the sun is where the scene puts it, with its irradiance whatever the size of the pixels") {
    const dvec3 expected = kinds::sunIrradiance(3, kinds::relativeAirMass(glm::radians(60.0)));
    for (const auto& [keys, degrees] : {std::pair<std::string, double>{", resolution: 512", 0.1},
                                        {", resolution: 512, sun_radius: 3", 0.02},
                                        {", resolution: 512, sun_radius: 0.001", 0.26}, // one pixel of 0.35 degrees
                                        {", resolution: 16", 8}}) {
        INFO(keys);
        const auto [irradiance, from] = sunOf(underSky(keys), underSky(keys + ", sun_scale: 0"));
        for (int channel = 0; channel < 3; ++channel) {
            CHECK_THAT(irradiance[channel], WithinRel(expected[channel], 1e-4)); // of floats, summed
        }
        CHECK(glm::degrees(std::acos(std::min(1.0, glm::dot(from, sunAt(60))))) < degrees);
    }
    const Scene hard = underSky(", sun_radius: 0");
    REQUIRE(hard.directionals.size() == 1);
    CHECK_THAT(glm::length(hard.directionals[0].direction + sunAt(60)), WithinAbs(0, 1e-5));
    CHECK_THAT(hard.directionals[0].irradiance.x, WithinRel(expected.x, 1e-4));
    CHECK(sunOf(hard, underSky(", sun_scale: 0")).first == dvec3(0));
}

TEST_CASE("an impossible sky is an error") {
    const auto messageOf = [](const std::string& keys) {
        const auto error = errorOf([&] { (void)underSky(keys); });
        REQUIRE(error.has_value());
        return error->message();
    };
    CHECK(messageOf("}\n  - {type: environment").find("a scene has at most one environment") != std::string::npos);
    CHECK(messageOf(", turbidity: 1").find("turbidity") != std::string::npos);
    CHECK(messageOf(", scale: 0").find("emits nothing") != std::string::npos);
    CHECK(messageOf("}\n  - {type: sky, sun: [0, -1, 0]").find("a scene has at most one environment") !=
          std::string::npos);
    TemporaryFolder folder;
    const auto error = errorOf([&] {
        (void)loadScene(
            folder.write("scene.yaml", "hyalite: 1\nlights:\n  - {type: sky, sun: [1, 0, 0]}\nobjects: []\n"));
    });
    REQUIRE(error.has_value());
    CHECK(error->message().find("above the horizon") != std::string::npos);
}
