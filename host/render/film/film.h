// The sums over passes that make the picture, one per layer and camera sequence, and the error estimate from them.
#pragma once

#include "image/error_estimate.h"
#include "image/layered_image.h"
#include "render/film/film_state.h"
#include "render/wavefront/device.h"

#include "shaders/shared/kernel_arguments.h"

#include <array>
#include <optional>

namespace hyalite::render {

class Film {
public:
    Film(Device& device, glm::uvec2 resolution, std::vector<LayerKind> layers);

    [[nodiscard]] std::uint32_t pixelCount() const { return resolution_.x * resolution_.y; }

    // Everything added from now on belongs to this pass, until it ends; at first, to pass 0.
    void beginPass(std::uint32_t pass) { pass_ = pass; }
    void endPass(); // call when the device has finished

    // Adds one colour per pixel to a layer; invalid values (NaN, infinite, negative, too bright) are counted and left
    // out.
    void add(Device& device, std::size_t layer, const gpu::Array<glm::vec3>& colors);

    [[nodiscard]] glm::uvec2 resolution() const { return resolution_; }
    [[nodiscard]] const PassSet& passes() const { return passes_; }
    [[nodiscard]] const std::vector<LayerKind>& layers() const { return layers_; }
    [[nodiscard]] const std::vector<FilmFault>& faults() const { return faults_; }

    // The means over the passes, of which there must be at least one, and their standard error.
    [[nodiscard]] LayeredImage resolve(Device& device);

    // The same bits every time.
    [[nodiscard]] ErrorEstimate estimateError(Device& device);

    // By pixel, 0 at first: kernels set 1 where a path looks for light at a surface that reflects it. A pixel without
    // light there is not known to be black.
    [[nodiscard]] shared::UintArray sought() const { return sought_; }

    // The whole state of the film, once the device has finished; restore() requires the same resolution and layers.
    [[nodiscard]] FilmState state() const;
    void restore(Device& device, const FilmState& state);

private:
    [[nodiscard]] shared::FilmArray sums(std::size_t sequence, std::size_t layer) const;

    static_assert(shared::kCameraSequences == 2, "the variance is estimated from two means");

    glm::uvec2 resolution_;
    std::vector<LayerKind> layers_;
    std::uint32_t pass_ = 0; // the pass being rendered
    PassSet passes_;
    std::vector<FilmFault> faults_; // of finished passes; layer after layer, kFilmFaults each
    gpu::Kernel accumulateFilm_;
    gpu::Kernel resolveFilm_;
    gpu::Kernel estimateError_;
    std::array<gpu::Array<shared::FilmColor>, shared::kCameraSequences> sums_; // layer after layer
    gpu::Array<glm::uvec2> passFaults_; // of this pass: number and lowest pixel; in the order of faults_
    gpu::Array<glm::vec3> image_;
    gpu::Array<float> errorSums_;
    gpu::Array<glm::uvec2> darkCounts_; // see EstimateErrorArguments
    gpu::Array<std::uint32_t> sought_;
};

} // namespace hyalite::render
