// Model of a clear or hazy daylight sky and of the sun through it [Preetham99], in SI units. +y is up.
#pragma once

#include <glm/glm.hpp>

namespace hyalite::kinds {

// Lumens per watt of white light over the visible range, as in Radiance [Ward94]; converts luminance to radiance:
// white light of luminance Y [cd/m^2] has the radiance Y / kWhiteEfficacy [W/(m^2 sr)] in each channel of linear sRGB.
inline constexpr double kWhiteEfficacy = 179;

// The sun seen from the Earth: radius over distance, and temperature [K] (IAU nominal values).
inline constexpr double kSunSine = 695700.0 / 149597870.7;
inline constexpr double kSunTemperature = 5772;

// Linear sRGB of a CIE 1931 XYZ colour; white (D65) with Y = 1 is (1, 1, 1). Channels may be negative.
[[nodiscard]] glm::dvec3 rgbOf(const glm::dvec3& xyz);

// The sky for a turbidity from 2 (very clear) to 10 (hazy) and a sun at an angle in [0, pi/2) from the zenith.
class SkyModel {
public:
    // `sun`: unit direction towards the sun, with y > 0.
    SkyModel(double turbidity, const glm::dvec3& sun);

    // Chromaticity (x, y) and luminance Y [cd/m^2] in a unit direction with y >= 0.
    [[nodiscard]] glm::dvec3 chromaticityAndLuminance(const glm::dvec3& direction) const;

    // Radiance per channel [W/(m^2 sr)] in a unit direction with y >= 0; negative channels are clamped to 0.
    [[nodiscard]] glm::dvec3 radiance(const glm::dvec3& direction) const;

private:
    // Perez' distribution: five coefficients, and the ratio of the zenith value to the distribution at the zenith.
    struct Quantity {
        double a, b, c, d, e;
        double scale;
        [[nodiscard]] double over(double cosTheta, double gamma) const;
    };
    Quantity x_;
    Quantity y_;
    Quantity luminance_; // [cd/m^2]
    glm::dvec3 sun_;
};

// Luminance [kcd/m^2] and chromaticity of the zenith; `theta` is the sun's angle from the zenith [radians].
[[nodiscard]] double zenithLuminance(double turbidity, double theta);
[[nodiscard]] glm::dvec2 zenithChromaticity(double turbidity, double theta);

// Relative optical air mass: the air that sunlight passes, relative to the sun at the zenith; `theta` as above.
[[nodiscard]] double relativeAirMass(double theta);

// Irradiance of a surface that faces the sun, per channel of linear sRGB [W/m^2]; with `air` = 0, above the atmosphere.
[[nodiscard]] glm::dvec3 sunIrradiance(double turbidity, double air);

} // namespace hyalite::kinds
