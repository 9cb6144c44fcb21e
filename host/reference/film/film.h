// Sums the passes of a picture per pixel, in pass order, and estimates its error from the difference between the passes
// of the two camera sequences.
#pragma once

#include "base/parallel.h"
#include "image/layered_image.h"

#include "shaders/shared/random.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace hyalite::reference {

// Several films of one picture.
class LayeredFilm {
public:
    LayeredFilm(std::uint32_t width, std::uint32_t height, std::vector<LayerKind> layers)
        : layers_(std::move(layers)), width_(width), height_(height) {
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
                result.error->pixels[pixel] = glm::vec3(glm::sqrt(variance(pixel)));
            }
        }
        return result;
    }

    // Root of the mean over pixels and channels of Var / (mean^2 + 0.01), with Var the estimated variance of the mean;
    // none before the second pass.
    [[nodiscard]] std::optional<double> error() const {
        if (passes_ < shared::kCameraSequences) {
            return std::nullopt;
        }
        glm::dvec3 sum(0);
        for (std::size_t pixel = 0; pixel < pixelCount(); ++pixel) {
            const glm::dvec3 mean = (light(0, pixel) + light(1, pixel)) / static_cast<double>(passes_);
            sum += variance(pixel) / (mean * mean + 0.01);
        }
        return std::sqrt((sum.x + sum.y + sum.z) / (3.0 * static_cast<double>(pixelCount())));
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

    static_assert(shared::kCameraSequences == 2);

    std::vector<LayerKind> layers_;
    std::uint32_t width_;
    std::uint32_t height_;
    std::uint32_t passes_ = 0;
    std::array<std::vector<glm::dvec3>, 2> sums_; // [W/(m^2 sr)] of each sequence; layer by layer within each pixel
};

// A picture of one layer.
class Film {
public:
    Film(std::uint32_t width, std::uint32_t height) : film_(width, height, {{"radiance"}}) {}

    // Adds radiance(pixel), a dvec3, to every pixel, from all cores at once.
    template <typename Radiance>
    void addPass(const Radiance& radiance) {
        film_.addPass([&](std::uint32_t pixel) { return std::array<glm::dvec3, 1>{radiance(pixel)}; });
    }

    [[nodiscard]] LayeredImage mean() const { return film_.mean(); }
    [[nodiscard]] std::optional<double> error() const { return film_.error(); }

private:
    LayeredFilm film_;
};

} // namespace hyalite::reference
