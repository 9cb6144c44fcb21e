// The sums over passes that become the picture: one per layer.
#pragma once

#include "image/layered_image.h"
#include "render/device.h"

#include "shaders/shared/kernel_arguments.h"

namespace hyalite::render {

class Film {
public:
    Film(Device& device, glm::uvec2 resolution, std::vector<LayerKind> layers);

    [[nodiscard]] std::uint32_t pixelCount() const { return resolution_.x * resolution_.y; }
    [[nodiscard]] const gpu::Array<glm::vec3>& sums(std::size_t layer) const { return sums_.at(layer); }

    // Adds one colour per pixel to a layer.
    void add(Device& device, std::size_t layer, const gpu::Array<glm::vec3>& colors) const;

    // The means over `passes` >= 1 passes.
    [[nodiscard]] LayeredImage resolve(Device& device, std::uint32_t passes) const;

private:
    glm::uvec2 resolution_;
    std::vector<LayerKind> layers_;
    gpu::Kernel accumulateFilm_;
    gpu::Kernel resolveFilm_;
    std::vector<gpu::Array<glm::vec3>> sums_;
    gpu::Array<glm::vec3> image_;
};

} // namespace hyalite::render
