// The sums over passes that become the picture, one per layer and camera sequence, and what they say of its error.
#pragma once

#include "image/layered_image.h"
#include "render/device.h"

#include "shaders/shared/kernel_arguments.h"

#include <array>
#include <optional>

namespace hyalite::render {

class Film {
public:
    Film(Device& device, glm::uvec2 resolution, std::vector<LayerKind> layers);

    [[nodiscard]] std::uint32_t pixelCount() const { return resolution_.x * resolution_.y; }

    // What is added from now on belongs to this pass; at first, to pass 0.
    void beginPass(std::uint32_t pass) { sequence_ = pass % shared::kCameraSequences; }
    [[nodiscard]] shared::ColorArray sums(std::size_t layer) const { return sums(sequence_, layer); }

    // Adds one colour per pixel to a layer.
    void add(Device& device, std::size_t layer, const gpu::Array<glm::vec3>& colors) const;

    // The means over `passes` >= 1 passes, those from 0 on, and their standard error.
    [[nodiscard]] LayeredImage resolve(Device& device, std::uint32_t passes) const;

    // Root of the mean over pixels and channels of Var / (mean^2 + 0.01), Var the estimated variance of the mean over
    // the `passes` so far; none before the second. The same bits every time.
    [[nodiscard]] std::optional<double> estimateError(Device& device, std::uint32_t passes) const;

private:
    [[nodiscard]] shared::ColorArray sums(std::size_t sequence, std::size_t layer) const;

    static_assert(shared::kCameraSequences == 2, "the variance is estimated from two means");

    glm::uvec2 resolution_;
    std::vector<LayerKind> layers_;
    std::uint32_t sequence_ = 0;
    gpu::Kernel accumulateFilm_;
    gpu::Kernel resolveFilm_;
    gpu::Kernel estimateError_;
    std::array<gpu::Array<glm::vec3>, shared::kCameraSequences> sums_; // layer after layer
    gpu::Array<glm::vec3> image_;
    gpu::Array<float> errorSums_;
};

} // namespace hyalite::render
