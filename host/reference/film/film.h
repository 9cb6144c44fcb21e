// Sums the passes of a picture per pixel, in pass order, and estimates its error from the difference between the passes
// of the two camera sequences.
#pragma once

#include "base/parallel.h"
#include "image/error_estimate.h"
#include "image/layered_image.h"

#include "shaders/shared/random.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace hyalite::reference {

// Does that pass's path of the pixel look for light at a surface that reflects it? Asked for black pixels.
using SeeksLight = std::function<bool(std::uint32_t pixel, std::uint32_t pass)>;

// Several films of one picture.
class LayeredFilm {
public:
    LayeredFilm(std::uint32_t width, std::uint32_t height, std::vector<LayerKind> layers, SeeksLight seeks)
        : layers_(std::move(layers)), width_(width), height_(height), seeks_(std::move(seeks)) {
        sums_.fill(std::vector<glm::dvec3>(pixelCount() * layers_.size(), glm::dvec3(0)));
    }

    // Adds radiances(pixel), one dvec3 per layer, to every pixel, from all cores at once.
    template <typename Radiances>
    void addPass(const Radiances& radiances) {
        constexpr std::size_t kBlock = 64; // short enough to balance costly pixels
        std::vector<glm::dvec3>& sums = sums_.at(passes_ % shared::kCameraSequences);
        parallelFor(pixelCount(), kBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t pixel = begin; pixel < end; ++pixel) {
                std::size_t at = pixel * layers_.size();
                for (const glm::dvec3& radiance : radiances(static_cast<std::uint32_t>(pixel))) {
                    sums.at(at++) += radiance;
                }
            }
        });
        ++passes_;
    }

    // Mean of the passes so far (black before the first) and its standard error.
    [[nodiscard]] LayeredImage mean() const {
        std::vector<Image> images;
        for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
            Image& image = images.emplace_back(blank());
            for (std::size_t pixel = 0; pixel < pixelCount() && passes_ > 0; ++pixel) {
                const std::size_t at = pixel * layers_.size() + layer;
                image.pixels[pixel] = glm::vec3((sums_[0][at] + sums_[1][at]) / static_cast<double>(passes_));
            }
        }
        LayeredImage result = compose(layers_, std::move(images));
        if (passes_ >= shared::kCameraSequences) {
            result.error = blank();
            for (std::size_t pixel = 0; pixel < pixelCount(); ++pixel) {
                result.error->pixels[pixel] =
                    glm::vec3(glm::sqrt(isUnknown(pixel) ? glm::dvec3(kFloor) : variance(pixel)));
            }
        }
        return result;
    }

    [[nodiscard]] ErrorEstimate error() const {
        ErrorEstimate estimate;
        if (passes_ < shared::kCameraSequences) {
            return estimate;
        }
        double sum = 0;
        bool isBlack = true;
        for (std::size_t pixel = 0; pixel < pixelCount(); ++pixel) {
            const glm::dvec3 mean = (light(0, pixel) + light(1, pixel)) / static_cast<double>(passes_);
            isBlack = isBlack && mean == glm::dvec3(0);
            const bool unknown = isUnknown(pixel);
            estimate.darkPixels += unknown ? 1 : 0;
            const glm::dvec3 relative = (unknown ? glm::dvec3(kFloor) : variance(pixel)) / (mean * mean + kFloor);
            sum += relative.x + relative.y + relative.z;
        }
        if (!isBlack) {
            estimate.error = std::sqrt(sum / (3.0 * static_cast<double>(pixelCount())));
        }
        return estimate;
    }

private:
    [[nodiscard]] std::size_t pixelCount() const { return std::size_t{width_} * height_; }
    [[nodiscard]] Image blank() const { return {static_cast<int>(width_), static_cast<int>(height_)}; }

    // Sum over the passes of one sequence and all layers that hold light.
    [[nodiscard]] glm::dvec3 light(std::size_t sequence, std::size_t pixel) const {
        glm::dvec3 sum(0);
        for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
            sum += layers_[layer].isLight ? sums_.at(sequence)[pixel * layers_.size() + layer] : glm::dvec3(0);
        }
        return sum;
    }

    // Variance of a pixel's mean: from the scatter of the two sequences' means about it, each weighted by its share of
    // the passes, with one degree of freedom.
    [[nodiscard]] glm::dvec3 variance(std::size_t pixel) const {
        const double all = passes_;
        const std::array<double, 2> passes{std::ceil(all / 2), std::floor(all / 2)};
        const glm::dvec3 mean = (light(0, pixel) + light(1, pixel)) / all;
        glm::dvec3 scatter(0);
        for (std::size_t sequence = 0; sequence < 2; ++sequence) {
            const glm::dvec3 off = light(sequence, pixel) / passes.at(sequence) - mean;
            scatter += passes.at(sequence) / all * off * off;
        }
        return scatter;
    }

    // No light was found where it was sought: any could be there, and the variance is not known to be 0.
    [[nodiscard]] bool isUnknown(std::size_t pixel) const {
        return light(0, pixel) + light(1, pixel) == glm::dvec3(0) &&
               seeks_(static_cast<std::uint32_t>(pixel), passes_ - 1);
    }

    static_assert(shared::kCameraSequences == 2);
    static constexpr double kFloor = 0.01; // of squared radiances in the error [(W/(m^2 sr))^2]

    std::vector<LayerKind> layers_;
    std::uint32_t width_;
    std::uint32_t height_;
    std::uint32_t passes_ = 0;
    SeeksLight seeks_;
    std::array<std::vector<glm::dvec3>, 2> sums_; // [W/(m^2 sr)] of each sequence; layer by layer within each pixel
};

// A picture of one layer.
class Film {
public:
    Film(std::uint32_t width, std::uint32_t height, SeeksLight seeks)
        : film_(width, height, {{"radiance"}}, std::move(seeks)) {}

    // Adds radiance(pixel), a dvec3, to every pixel, from all cores at once.
    template <typename Radiance>
    void addPass(const Radiance& radiance) {
        film_.addPass([&](std::uint32_t pixel) { return std::array<glm::dvec3, 1>{radiance(pixel)}; });
    }

    [[nodiscard]] LayeredImage mean() const { return film_.mean(); }
    [[nodiscard]] ErrorEstimate error() const { return film_.error(); }

private:
    LayeredFilm film_;
};

} // namespace hyalite::reference
