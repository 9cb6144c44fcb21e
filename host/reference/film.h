// Sums the passes of a picture, pixel by pixel and in the order of the passes.
#pragma once

#include "base/parallel.h"
#include "image/layered_image.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

namespace hyalite::reference {

class Film {
public:
    Film(std::uint32_t width, std::uint32_t height)
        : width_(width), height_(height), sums_(std::size_t{width} * height, glm::dvec3(0)) {}

    // Adds radiance(pixel), a dvec3, to every pixel, from all cores at once.
    template <typename Radiance>
    void addPass(const Radiance& radiance) {
        constexpr std::size_t kBlock = 64; // short enough to even out costly pixels
        parallelFor(sums_.size(), kBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t pixel = begin; pixel < end; ++pixel) {
                sums_[pixel] += radiance(static_cast<std::uint32_t>(pixel));
            }
        });
        ++passes_;
    }

    // The mean of the passes so far; black before the first.
    [[nodiscard]] Image mean() const {
        Image image(static_cast<int>(width_), static_cast<int>(height_));
        for (std::size_t pixel = 0; pixel < sums_.size() && passes_ > 0; ++pixel) {
            image.pixels[pixel] = glm::vec3(sums_[pixel] / static_cast<double>(passes_));
        }
        return image;
    }

private:
    std::uint32_t width_;
    std::uint32_t height_;
    std::uint32_t passes_ = 0;
    std::vector<glm::dvec3> sums_; // [W/(m^2 sr)]
};

// Several films of one picture.
class LayeredFilm {
public:
    LayeredFilm(std::uint32_t width, std::uint32_t height, std::vector<LayerKind> layers)
        : layers_(std::move(layers)), width_(width), height_(height),
          sums_(std::size_t{width} * height * layers_.size()) {}

    // Adds radiances(pixel), one dvec3 per layer, to every pixel, from all cores at once.
    template <typename Radiances>
    void addPass(const Radiances& radiances) {
        constexpr std::size_t kBlock = 64;
        parallelFor(std::size_t{width_} * height_, kBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t pixel = begin; pixel < end; ++pixel) {
                std::size_t at = pixel * layers_.size();
                for (const glm::dvec3& radiance : radiances(static_cast<std::uint32_t>(pixel))) {
                    sums_.at(at++) += radiance;
                }
            }
        });
        ++passes_;
    }

    // The means of the passes so far, one at least.
    [[nodiscard]] LayeredImage mean() const {
        std::vector<Image> images;
        for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
            Image& image = images.emplace_back(static_cast<int>(width_), static_cast<int>(height_));
            for (std::size_t pixel = 0; pixel < image.pixels.size(); ++pixel) {
                image.pixels[pixel] = glm::vec3(sums_[pixel * layers_.size() + layer] / static_cast<double>(passes_));
            }
        }
        return compose(layers_, std::move(images));
    }

private:
    std::vector<LayerKind> layers_;
    std::uint32_t width_;
    std::uint32_t height_;
    std::uint32_t passes_ = 0;
    std::vector<glm::dvec3> sums_; // layer by layer within each pixel
};

} // namespace hyalite::reference
