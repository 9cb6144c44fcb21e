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

// Running sums over their total, which is returned.
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
    double rest = 0; // where x lies between the element's ends, [0, 1)
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
        // Colatitudes pi y / height: the solid angle between two of them is 2 pi times the difference of the cosines
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
    // Evenly in the cosine of the colatitude and in the azimuth
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

} // namespace hyalite::reference
