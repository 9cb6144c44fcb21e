// What a render says of itself afterwards: a line, a table of stages, or one JSON object.
#pragma once

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
    glm::uvec2 resolution{0};
    std::vector<std::string> outputs;
    std::uint32_t passes = 0;
    double totalSeconds = 0; // from start to written files
    double setupSeconds = 0;
    double renderSeconds = 0;
    std::optional<render::Counts> counts; // the reference does not count
    render::RenderNotes notes;
    std::map<std::string, gpu::StageTime> stages;
};

[[nodiscard]] std::string jsonReport(const RenderReport& report);

// Stages by falling share: seconds, share of all stages, dispatches, nanoseconds a thread.
[[nodiscard]] std::string stageTable(const RenderReport& report);

// What became of the flux of each light [W], and what the photon maps saved; empty where no account was kept.
[[nodiscard]] std::string photonTable(const RenderReport& report);

} // namespace hyalite::cli
