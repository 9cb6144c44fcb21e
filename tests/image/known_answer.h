// Pictures whose radiance is known on paper, asked of every integrator on both sides: a table of renderers, and the
// samples that the tests of chance (support/statistics.h) judge.
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

// Every integrator by both.
[[nodiscard]] const std::vector<Renderer>& everyRenderer();

// Those of the integrators.
[[nodiscard]] std::vector<Renderer> renderersOf(std::span<const std::string_view> integrators);

// The scene's picture by that integrator on that side.
[[nodiscard]] Image renderBy(const Renderer& renderer, Scene scene);

// The red channel of every pixel over what it should be, expected(x, y). Where a pixel's light is the work of its own
// random numbers alone, as it is without photons, these are independent samples of 1.
using ExpectedPixel = std::function<double(int x, int y)>;
[[nodiscard]] ExpectedPixel everywhere(double radiance);
[[nodiscard]] std::vector<double> pixelRatios(const Image& image, const ExpectedPixel& expected);

// The mean of these of so many renders, seeds 1, 2, …: where pixels share photons, only renders are independent.
[[nodiscard]] std::vector<double> renderRatios(const Renderer& renderer, Scene scene, std::uint32_t renders,
                                               const ExpectedPixel& expected);

// Whether pixels or only renders are independent samples.
enum class Independent { Pixels, Renders };

// Is the mean over the pixels what it should be? One comparison; of renders, 16. Making photonmap's kernels takes
// longer than all of its other work here: of the device it judges one render, by the scatter of the reference's.
[[nodiscard]] Verdict judge(FalseAlarms& alarms, const Renderer& renderer, const Scene& scene,
                            const ExpectedPixel& expected, Independent independent, const Sharpness& sharpness);

} // namespace hyalite::testing
