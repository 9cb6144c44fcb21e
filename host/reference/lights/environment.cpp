// See environment.h.
#include "reference/lights/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hyalite::reference {

namespace {

using std::numbers::pi;

double channelMean(const glm::dvec3& c) {
    return (c.x + c.y + c.z) / 3;
}

// Turns the weights into their normalised running sums; returns their total.
double makeCdf(std::vector<double>& weights) {
    double sum = 0;
    for (double& weight : weights) {
        sum += weight;
        weight = sum;
    }
    for (double& weight : weights) {
        weight = sum > 0 ? weight / sum : 1;
    }
    return sum;
}

struct Choice {
    int index = 0;
    double rest = 0; // position of x within the element, [0, 1)
};
Choice choose(const std::vector<double>& cdf, double x) {
    const auto found = std::upper_bound(cdf.begin(), cdf.end() - 1, x);
    const double before = found == cdf.begin() ? 0 : *(found - 1);
    return {static_cast<int>(found - cdf.begin()), (x - before) / (*found - before)};
}

} // namespace

EnvironmentLight::EnvironmentLight(const Environment& environment)
    : image_(environment.image), scale_(environment.scale), turns_(environment.rotation / 360) {
    for (int y = 0; y < image_.height; ++y) {
        // Colatitudes pi y / height: the solid angle between two of them is 2 pi times the difference of their cosines
        const double solidAngle =
            2 * pi / image_.width * (std::cos(pi * y / image_.height) - std::cos(pi * (y + 1) / image_.height));
        std::vector<double> weights;
        for (int x = 0; x < image_.width; ++x) {
            const glm::dvec3 flux = glm::dvec3(image_.at(x, y)) * (scale_ * solidAngle);
            integral_ += flux;
            weights.push_back(channelMean(flux));
        }
        rowCdf_.push_back(makeCdf(weights));
        columnCdf_.push_back(std::move(weights));
    }
    makeCdf(rowCdf_);
}

glm::dvec3 EnvironmentLight::radiance(const glm::dvec3& direction) const {
    const double around = std::atan2(-direction.x, direction.z) / (2 * pi) + turns_;
    const double down = std::atan2(std::hypot(direction.x, direction.z), direction.y) / pi;
    const int column = static_cast<int>((around - std::floor(around)) * image_.width);
    const int row = static_cast<int>(down * image_.height);
    return glm::dvec3(image_.at(std::min(column, image_.width - 1), std::min(row, image_.height - 1))) * scale_;
}

glm::dvec3 EnvironmentLight::sample(glm::dvec2 uv) const {
    const Choice row = choose(rowCdf_, uv.y);
    const Choice column = choose(columnCdf_.at(static_cast<std::size_t>(row.index)), uv.x);
    // Uniform in the cosine of the colatitude and in the azimuth
    const double top = std::cos(pi * row.index / image_.height);
    const double bottom = std::cos(pi * (row.index + 1) / image_.height);
    const double cosine = std::clamp(top + row.rest * (bottom - top), -1.0, 1.0);
    const double sine = std::sqrt(1 - cosine * cosine);
    const double phi = 2 * pi * ((column.index + column.rest) / image_.width - turns_);
    return {-sine * std::sin(phi), cosine, sine * std::cos(phi)};
}

double EnvironmentLight::pdfW(const glm::dvec3& direction) const {
    return channelMean(radiance(direction)) / channelMean(integral_);
}

Offer offerTo(const glm::dvec3& receiver, const SurroundingLight& light, glm::dvec2 uv) {
    const glm::dvec3 direction = light.map.sample(uv);
    const double pdfW = light.map.pdfW(direction);
    const glm::dvec3 way = kBeyond * direction;
    return {.toLight = way,
            .shadowEnd = receiver + way,
            .irradiance = pdfW > 0 ? light.map.radiance(direction) / pdfW : glm::dvec3(0),
            .pdfW = pdfW};
}

double pdfToward(const SurroundingLight& light, const glm::dvec3& direction, double /*distance*/,
                 const glm::dvec3& /*lightNormal*/) {
    return light.map.pdfW(direction);
}

LightRay emitFrom(const SurroundingLight& light, glm::dvec2 uOrigin, glm::dvec2 uDirection) {
    const glm::dvec3 d = -light.map.sample(uDirection);
    const StartDisc disc{light.sphere.center - light.sphere.distance * d, light.sphere.radius};
    return {.origin = disc.point(d, uOrigin), .direction = d, .pdfOrigin = 1 / disc.area()};
}

double emissionDensity(const SurroundingLight& light, const glm::dvec3& /*normal*/, const glm::dvec3& direction) {
    return light.map.pdfW(-direction);
}

double emissionCosine(const SurroundingLight& /*light*/) {
    return -1;
}

std::optional<StartDisc> startDisc(const SurroundingLight& light) {
    return StartDisc{light.sphere.center, light.sphere.radius};
}

glm::dvec3 rayPower(const SurroundingLight& light, const glm::dvec3& direction) {
    const double pdfW = light.map.pdfW(-direction);
    const double discArea = pi * light.sphere.radius * light.sphere.radius;
    return pdfW > 0 ? light.map.radiance(-direction) * (discArea / pdfW) : glm::dvec3(0);
}

glm::dvec3 fluxOf(const SurroundingLight& light) {
    return pi * light.sphere.radius * light.sphere.radius * light.map.integral();
}

} // namespace hyalite::reference
