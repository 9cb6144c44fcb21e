// Parity of the device with the double-precision reference: stage by stage on what a render really computes, and the
// picture that comes of it.
#pragma once

#include "gpu/context.h"
#include "gpu/shader_compiler.h"
#include "image/error_map.h"
#include "image/image.h"
#include "parity/comparison.h"
#include "parity/inspection_session.h"
#include "parity/path_comparison.h"
#include "scene/model/scene.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace hyalite::parity {

struct Options {
    std::set<std::string> stages; // compare these alone; empty: all, and paths and picture too
};

// Both pictures, and how far they are from one another.
struct PictureResult {
    Image device;
    Image twin;
    ErrorMap flipMap;
    double rmse = 0;
    double relMse = 0;
    double flip = 0;
    double shareWithin = 0; // of pixels, by kPictureTolerance
    [[nodiscard]] bool passed() const;
};
// A pixel agrees within this share of its value. Where a path takes another way, because a coin or an edge is decided
// by a rounding, its pixel differs by what the way brings; so not all pixels need to agree.
inline constexpr double kPictureTolerance = 1e-2;
inline constexpr double kPictureShare = 0.95;

struct Result {
    std::vector<StageResult> stages; // in the order of their first dispatch
    std::optional<PathResults> paths;
    std::optional<PictureResult> picture;
    std::vector<RecordedPath> shown; // of every pixel in pass 0, for a report; none of large pictures

    [[nodiscard]] bool passed() const;
    // The stage of the earliest dispatch that failed; nullptr: none.
    [[nodiscard]] const StageResult* firstFailure() const;
};

// Renders the scene, as it is, on both sides. Throws what render::render and reference::render throw.
[[nodiscard]] Result compareSides(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene,
                                  const Options& options);

// The path of a pixel (y * width + x) in a pass.
[[nodiscard]] RecordedPath inspectPixel(const gpu::Context& context, const gpu::ShaderCompiler& compiler,
                                        const Scene& scene, std::uint32_t pass, std::uint32_t pixel);

// The path of a photon in a pass. Throws Error(WrongUsage) where there is none of that kind and number.
[[nodiscard]] RecordedPath inspectPhoton(const gpu::Context& context, const gpu::ShaderCompiler& compiler,
                                         const Scene& scene, std::uint32_t pass, const PhotonChoice& photon);

// Lowers resolution, passes and photons to what is compared in a minute: at most 64 pixels a side, 2 passes and 8192
// photons of a kind.
void shrinkToTestSize(Scene& scene);

} // namespace hyalite::parity
