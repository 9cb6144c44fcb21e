// Pictures of many small scenes: on the device all scenes share their kernels.
#pragma once

#include "image/known_answer.h"

namespace hyalite::testing {

// The scene's picture for each of the seeds first, first + 1, …; `count` of them. On the device all scenes of a program
// use kernels that know every kind of shape, material and light (render() leaves out what a scene lacks), so that few
// kernels are created; no scene may have custom code.
[[nodiscard]] std::vector<Image> renderSeeds(const Renderer& renderer, Scene scene, std::uint32_t first,
                                             std::uint32_t count);

// Mean of the picture's red channel.
[[nodiscard]] double meanOf(const Image& image);

} // namespace hyalite::testing
