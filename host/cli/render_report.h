// The report of a render: a line, tables (--profile), or one JSON object.
#pragma once

#include "base/error.h"
#include "image/image_io.h"
#include "render/renderer.h"

#include <optional>
#include <string>
#include <vector>

namespace hyalite::cli {

struct RenderReport {
    std::string scene;
    std::string integrator;
    std::string backend;
    std::string device; // name and driver
    std::uint32_t seed = 0;
    std::string sampler;
    glm::uvec2 resolution{0};
    std::vector<std::string> outputs;
    std::uint32_t passes = 0;
    std::uint32_t resumedFrom = 0; // number of these passes that the checkpoint held
    bool interrupted = false;
    std::optional<Error> checkpointFailure;
    ErrorEstimate errorEstimate;
    double targetError = 0;  // requested; 0: none
    double totalSeconds = 0; // from the start until the files are written
    double setupSeconds = 0;
    double renderSeconds = 0;
    std::optional<render::Counts> counts;   // the reference does not count
    std::vector<std::string> sceneWarnings; // printed before the render
    render::RenderNotes notes;
    std::map<std::string, std::size_t> memory; // bytes of the device's buffers, by name
    std::map<std::string, gpu::StageTime> stages;
};

// Whether the estimated error is at most the target.
[[nodiscard]] bool targetErrorMet(const RenderReport& report);

// Adds a warning if the target was missed.
void warnOfTarget(RenderReport& report);

// The end of the summary line, e.g. ", estimated error 0.0312 (target 0.05 met)"; empty without an estimate.
[[nodiscard]] std::string errorText(const RenderReport& report);

// The metadata of .exr files.
[[nodiscard]] Metadata pictureMetadata(const RenderReport& report);

// Writes the picture to every file; `layers`: also its layers and its error to files that can hold layers.
void writePictures(const std::vector<std::string>& outputs, const LayeredImage& image, bool layers,
                   const Metadata& metadata);

// Prints on stdout all but the warnings.
struct ReportStyle {
    bool json = false;
    bool profile = false;
    bool quiet = false;
};
void printReport(const RenderReport& report, const ReportStyle& style);

[[nodiscard]] std::string jsonReport(const RenderReport& report);

// Stages by decreasing time: seconds, share of all stages, dispatches, nanoseconds per thread.
[[nodiscard]] std::string stageTable(const RenderReport& report);

// Buffers by decreasing size.
[[nodiscard]] std::string memoryTable(const RenderReport& report);

// Where the flux of each light went [W]; empty without such an account.
[[nodiscard]] std::string lightTable(const RenderReport& report);

// The nonzero counters (render/film/counts.h), a line each; empty without counters.
[[nodiscard]] std::string countTable(const RenderReport& report);

} // namespace hyalite::cli
