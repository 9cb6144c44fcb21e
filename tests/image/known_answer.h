// Pictures with analytically known radiance, rendered by every integrator on both sides: a table of renderers, and the
// samples for the statistical tests (support/statistics.h).
#pragma once

#include "scene/model/scene.h"
#include "support/statistics.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite::testing {

enum class Backend { Vulkan, Reference };

struct Renderer {
    std::string name;
    std::string_view integrator; // its name
    Backend backend;
};

// Every integrator on both sides.
[[nodiscard]] const std::vector<Renderer>& everyRenderer();

// The renderers of these integrators.
[[nodiscard]] std::vector<Renderer> renderersOf(std::span<const std::string_view> integrators);

// The scene's picture by that integrator on that side.
[[nodiscard]] Image renderBy(const Renderer& renderer, Scene scene);

// The red channel of every pixel divided by its expected value, expected(x, y). If a pixel depends only on its own
// random numbers, as without photons, these are independent samples of 1.
using ExpectedPixel = std::function<double(int x, int y)>;
[[nodiscard]] ExpectedPixel everywhere(double radiance);
[[nodiscard]] std::vector<double> pixelRatios(const Image& image, const ExpectedPixel& expected);

// The mean of these for each of `count` renders with seeds 1, 2, …: if pixels share photons, only renders are
// independent.
[[nodiscard]] std::vector<double> renderRatios(const Renderer& renderer, Scene scene, std::uint32_t renders,
                                               const ExpectedPixel& expected);

// True if pixels, not only renders, are independent samples.
enum class Independent { Pixels, Renders };

// Tests the mean over the pixels against its expected value: one comparison, from 16 renders if only renders are
// independent. Creating photonmap's kernels takes longer than all of its other work here: on the device a single render
// is judged, by the scatter of the reference's renders.
[[nodiscard]] Verdict judge(FalseAlarms& alarms, const Renderer& renderer, const Scene& scene,
                            const ExpectedPixel& expected, Independent independent, const Sharpness& sharpness);

} // namespace hyalite::testing
