// The sum of the passes, and the picture as their mean.
#pragma once

#include "image/image.h"
#include "render/device.h"

#include "shaders/shared/kernel_arguments.h"

namespace hyalite::render {

class Film {
public:
    Film(Device& device, glm::uvec2 resolution);

    [[nodiscard]] const gpu::Array<glm::vec3>& sums() const { return sums_; }
    [[nodiscard]] std::uint32_t pixelCount() const { return resolution_.x * resolution_.y; }

    // The mean over `passes` >= 1 passes.
    [[nodiscard]] Image resolve(Device& device, std::uint32_t passes) const;

private:
    glm::uvec2 resolution_;
    gpu::Kernel resolveFilm_;
    gpu::Array<glm::vec3> sums_;
    gpu::Array<glm::vec3> image_;
};

} // namespace hyalite::render
