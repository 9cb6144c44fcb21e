// Parity of the device with the double-precision reference: stage by stage on the data of an actual render, and on the
// final picture.
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
    std::set<std::string> stages; // compares only these; empty: all, and paths and picture too
};

// Both pictures and the difference between them.
struct PictureResult {
    Image device;
    Image twin;
    ErrorMap flipMap;
    double rmse = 0;
    double relMse = 0;
    double flip = 0;
    double shareWithin = 0; // share of pixels within kPictureTolerance
    [[nodiscard]] bool passed() const;
};
// A pixel agrees if it is within this fraction of its value. Where rounding flips a random decision or an edge test,
// the path diverges and its pixel differs by the path's contribution; so not all pixels need to agree.
inline constexpr double kPictureTolerance = 1e-2;
inline constexpr double kPictureShare = 0.95;

struct Result {
    std::vector<StageResult> stages; // in the order of their first dispatch
    std::optional<PathResults> paths;
    std::optional<PictureResult> picture;
    std::vector<RecordedPath> shown; // of every pixel in pass 0, for a report; empty for large pictures

    [[nodiscard]] bool passed() const;
    // The stage of the earliest failed dispatch; nullptr: none failed.
    [[nodiscard]] const StageResult* firstFailure() const;
};

// Renders the unmodified scene on both sides. Throws what render::render and reference::render throw.
[[nodiscard]] Result compareSides(const gpu::Context& context, const gpu::ShaderCompiler& compiler, const Scene& scene,
                                  const Options& options);

// The path of a pixel (y * width + x) in a pass.
[[nodiscard]] RecordedPath inspectPixel(const gpu::Context& context, const gpu::ShaderCompiler& compiler,
                                        const Scene& scene, std::uint32_t pass, std::uint32_t pixel);

// The path of a photon in a pass. Throws Error(WrongUsage) if there is no photon of that kind and number.
[[nodiscard]] RecordedPath inspectPhoton(const gpu::Context& context, const gpu::ShaderCompiler& compiler,
                                         const Scene& scene, std::uint32_t pass, const PhotonChoice& photon);

// Lowers resolution, passes and photons so that the comparison takes at most a minute: at most 64 pixels a side, 2
// passes and 8192 photons of each kind.
void shrinkToTestSize(Scene& scene);

} // namespace hyalite::parity
