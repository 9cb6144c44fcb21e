// The clear or hazy sky by day, and the sun through it [Preetham99]: numbers only, in SI units. Directions have +y up.
#pragma once

#include <glm/glm.hpp>

namespace hyalite::kinds {

// Lumens to a watt of white light over the visible range, as in Radiance [Ward94]: what makes luminance a radiance.
// White light of the luminance Y [cd/m^2] has the radiance Y / kWhiteEfficacy [W/(m^2 sr)] in each channel of linear
// sRGB.
inline constexpr double kWhiteEfficacy = 179;

// The sun from the Earth: its radius over its distance, and its temperature [K] (IAU's nominal values).
inline constexpr double kSunSine = 695700.0 / 149597870.7;
inline constexpr double kSunTemperature = 5772;

// Linear sRGB of a colour of the CIE's 1931 observer; white (D65) of Y = 1 is (1, 1, 1). Channels may be negative.
[[nodiscard]] glm::dvec3 rgbOf(const glm::dvec3& xyz);

// The sky over a turbidity T, 2 (very clear) to 10 (hazy), and a sun whose angle from the zenith is in [0, pi/2).
class SkyModel {
public:
    // `sun`: unit, towards it, with y > 0.
    SkyModel(double turbidity, const glm::dvec3& sun);

    // (x, y, Y) with the chromaticity x, y and the luminance Y [cd/m^2], from the unit direction with y >= 0.
    [[nodiscard]] glm::dvec3 chromaticityAndLuminance(const glm::dvec3& direction) const;

    // Radiance per channel [W/(m^2 sr)], likewise; colours beyond sRGB lose what is negative.
    [[nodiscard]] glm::dvec3 radiance(const glm::dvec3& direction) const;

private:
    // Perez' distribution: five coefficients, and the value at the zenith over the distribution there.
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

// Luminance of the zenith [kcd/m^2] and its chromaticity, `theta` the sun's angle from it [radians].
[[nodiscard]] double zenithLuminance(double turbidity, double theta);
[[nodiscard]] glm::dvec2 zenithChromaticity(double turbidity, double theta);

// The air on the way of the sun's light, in atmospheres straight above; `theta` as above.
[[nodiscard]] double relativeAirMass(double theta);

// Irradiance of a surface that faces the sun, per channel of linear sRGB [W/m^2]; with `air` = 0, above the atmosphere.
[[nodiscard]] glm::dvec3 sunIrradiance(double turbidity, double air);

} // namespace hyalite::kinds
