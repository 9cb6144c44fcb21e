// See sky_model.h. Numbers without another source are from appendix A.2 of [Preetham99].
#include "kinds/lights/sky_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hyalite::kinds {
namespace {

using glm::dvec3;
using std::numbers::pi;

// One lobe of the fits below.
double lobe(double wavelength, double middle, double below, double above) {
    const double t = (wavelength - middle) / (wavelength < middle ? below : above);
    return std::exp(-0.5 * t * t);
}

// The CIE 1931 colour matching functions, wavelength in nm: the multi-lobe fit of [Wyman13, eq. 4].
dvec3 colorMatching(double nm) {
    return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
                0.065 * lobe(nm, 501.1, 20.4, 26.2),
            0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
            1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

// Planck's law [W/(m^2 sr m)], wavelength in m.
double blackBody(double wavelength, double kelvin) {
    constexpr double h = 6.62607015e-34;
    constexpr double c = 2.99792458e8;
    constexpr double k = 1.380649e-23;
    return 2 * h * c * c / std::pow(wavelength, 5) / std::expm1(h * c / (wavelength * k * kelvin));
}

double cubed(double x) {
    return x * x * x;
}

} // namespace

// IEC 61966-2-1.
dvec3 rgbOf(const dvec3& xyz) {
    return {3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z, -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
            0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z};
}

double zenithLuminance(double turbidity, double theta) {
    const double chi = (4.0 / 9 - turbidity / 120) * (pi - 2 * theta);
    return (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192;
}

glm::dvec2 zenithChromaticity(double turbidity, double theta) {
    const double t3 = cubed(theta);
    const double t2 = theta * theta;
    return {turbidity * turbidity * (0.00166 * t3 - 0.00375 * t2 + 0.00209 * theta) +
                turbidity * (-0.02903 * t3 + 0.06377 * t2 - 0.03202 * theta + 0.00394) +
                (0.11693 * t3 - 0.21196 * t2 + 0.06052 * theta + 0.25886),
            turbidity * turbidity * (0.00275 * t3 - 0.00610 * t2 + 0.00317 * theta) +
                turbidity * (-0.04214 * t3 + 0.08970 * t2 - 0.04153 * theta + 0.00516) +
                (0.15346 * t3 - 0.26756 * t2 + 0.06670 * theta + 0.26688)};
}

// Equation 3. At the horizon the first exponential is 0, because b < 0.
double SkyModel::Quantity::over(double cosTheta, double gamma) const {
    const double cosGamma = std::cos(gamma);
    const double height = cosTheta > 0 ? std::exp(b / cosTheta) : 0;
    return scale * (1 + a * height) * (1 + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
}

SkyModel::SkyModel(double turbidity, const dvec3& sun)
    : x_{-0.0193 * turbidity - 0.2592, -0.0665 * turbidity + 0.0008, -0.0004 * turbidity + 0.2125,
         -0.0641 * turbidity - 0.8989, -0.0033 * turbidity + 0.0452, 1},
      y_{-0.0167 * turbidity - 0.2608, -0.0950 * turbidity + 0.0092, -0.0079 * turbidity + 0.2102,
         -0.0441 * turbidity - 1.6537, -0.0109 * turbidity + 0.0529, 1},
      luminance_{0.1787 * turbidity - 1.4630, -0.3554 * turbidity + 0.4275, -0.0227 * turbidity + 5.3251,
                 0.1206 * turbidity - 2.5771, -0.0670 * turbidity + 0.3703, 1},
      sun_(sun) {
    const double theta = std::acos(std::clamp(sun.y, 0.0, 1.0));
    const glm::dvec2 chromaticity = zenithChromaticity(turbidity, theta);
    x_.scale = chromaticity.x / x_.over(1, theta); // equation 4: Y_z F(theta, gamma) / F(0, theta_s)
    y_.scale = chromaticity.y / y_.over(1, theta);
    luminance_.scale = 1000 * zenithLuminance(turbidity, theta) / luminance_.over(1, theta);
}

dvec3 SkyModel::chromaticityAndLuminance(const dvec3& direction) const {
    const double gamma = std::acos(std::clamp(glm::dot(direction, sun_), -1.0, 1.0));
    return {x_.over(direction.y, gamma), y_.over(direction.y, gamma), luminance_.over(direction.y, gamma)};
}

dvec3 SkyModel::radiance(const dvec3& direction) const {
    const dvec3 xyY = chromaticityAndLuminance(direction);
    const dvec3 xyz = xyY.z / xyY.y * dvec3(xyY.x, xyY.y, 1 - xyY.x - xyY.y);
    return glm::max(rgbOf(xyz), dvec3(0)) / kWhiteEfficacy;
}

double relativeAirMass(double theta) {
    return 1 / (std::cos(theta) + 0.15 * std::pow(93.885 - theta * 180 / pi, -1.253));
}

// Appendix A.1: the sun's spectrum (here a black body with the solar constant 1361 W/m^2) through molecules and haze.
// The air mass multiplies the extinction; the paper has it in the exponent of the wavelength, which is a misprint.
// Ozone, other gases and water vapour, whose absorption needs tables, are left out: they absorb 3 % of green light at
// noon.
dvec3 sunIrradiance(double turbidity, double air) {
    constexpr double kStep = 5; // [nm]
    const double beta = 0.04608 * turbidity - 0.04586;
    dvec3 xyz(0);
    for (double nm = 380; nm <= 780; nm += kStep) {
        const double um = nm / 1000;
        const double rayleigh = std::exp(-0.008735 * std::pow(um, -4.08) * air);
        const double aerosol = std::exp(-beta * std::pow(um, -1.3) * air);
        const double above = pi * kSunSine * kSunSine * blackBody(nm * 1e-9, kSunTemperature); // [W/(m^2 m)]
        xyz += above * rayleigh * aerosol * kStep * 1e-9 * colorMatching(nm);
    }
    constexpr double kLuminousEfficacy = 683; // [lm/W] at the peak of the eye's sensitivity
    return glm::max(rgbOf(kLuminousEfficacy * xyz), dvec3(0)) / kWhiteEfficacy;
}

} // namespace hyalite::kinds
