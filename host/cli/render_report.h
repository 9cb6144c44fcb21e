// What a render says of itself afterwards: a line, a table of stages, or one JSON object.
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
    std::uint32_t resumedFrom = 0; // of these, so many were in the checkpoint
    bool interrupted = false;
    std::optional<Error> checkpointFailure;
    std::optional<double> errorEstimate; // see docs/metrics.md
    double targetError = 0;              // asked for; 0: none
    double totalSeconds = 0;             // from start to written files
    double setupSeconds = 0;
    double renderSeconds = 0;
    std::optional<render::Counts> counts; // the reference does not count
    render::RenderNotes notes;
    std::map<std::string, std::size_t> memory; // bytes of the device's buffers, by name
    std::map<std::string, gpu::StageTime> stages;
};

// Whether the estimated error is no larger than what was asked for.
[[nodiscard]] bool targetErrorMet(const RenderReport& report);

// Adds a warning where it is larger.
void warnOfTarget(RenderReport& report);

// For the end of the summary, e.g. ", estimated error 0.0312 (target 0.05 met)"; empty where there is no estimate.
[[nodiscard]] std::string errorText(const RenderReport& report);

// What .exr files say of their making.
[[nodiscard]] Metadata pictureMetadata(const RenderReport& report);

// Writes the picture to every file; `layers`: and what it is the sum of, and its error, to those that hold layers.
void writePictures(const std::vector<std::string>& outputs, const LayeredImage& image, bool layers,
                   const Metadata& metadata);

// Warnings on stderr, the rest on stdout.
struct ReportStyle {
    bool json = false;
    bool profile = false;
    bool quiet = false;
};
void printReport(const RenderReport& report, const ReportStyle& style);

[[nodiscard]] std::string jsonReport(const RenderReport& report);

// Stages by falling share: seconds, share of all stages, dispatches, nanoseconds a thread.
[[nodiscard]] std::string stageTable(const RenderReport& report);

// Buffers by falling size.
[[nodiscard]] std::string memoryTable(const RenderReport& report);

// What became of the flux of each light [W]; empty where no account was kept.
[[nodiscard]] std::string lightTable(const RenderReport& report);

// The counters (render/film/counts.h) that are not zero, a line each; empty where nothing was counted.
[[nodiscard]] std::string countTable(const RenderReport& report);

} // namespace hyalite::cli
