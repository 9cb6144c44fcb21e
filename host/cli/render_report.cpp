#include "cli/render_report.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace hyalite::cli {

std::string jsonReport(const RenderReport& report) {
    nlohmann::ordered_json object;
    object["version"] = HYALITE_VERSION;
    object["scene"] = report.scene;
    object["integrator"] = report.integrator;
    object["backend"] = report.backend;
    object["device"] = report.device;
    object["seed"] = report.seed;
    object["resolution"] = {report.resolution.x, report.resolution.y};
    object["passes"] = report.passes;
    object["seconds"] = {
        {"total", report.totalSeconds}, {"setup", report.setupSeconds}, {"render", report.renderSeconds}};
    if (report.counts) {
        object["counts"] = {{"camera_rays", report.counts->cameraRays},
                            {"shadow_rays", report.counts->shadowRays},
                            {"photon_rays", report.counts->photonRays},
                            {"photons_emitted", report.counts->photonsEmitted},
                            {"photons_stored", report.counts->photonsStored}};
    }
    for (const auto& [name, time] : report.stages) {
        object["stages"][name] = {
            {"seconds", time.seconds}, {"dispatches", time.dispatches}, {"threads", time.threads}};
    }
    object["outputs"] = report.outputs;
    return object.dump(2);
}

std::string stageTable(const RenderReport& report) {
    std::vector<std::pair<std::string, gpu::StageTime>> stages(report.stages.begin(), report.stages.end());
    std::ranges::sort(stages, [](const auto& a, const auto& b) { return a.second.seconds > b.second.seconds; });
    double total = 0;
    for (const auto& [name, time] : stages) {
        total += time.seconds;
    }
    std::ostringstream table;
    table << std::fixed << std::left << std::setw(24) << "stage" << std::right << std::setw(10) << "seconds"
          << std::setw(9) << "share" << std::setw(12) << "dispatches" << std::setw(12) << "ns/thread" << '\n';
    for (const auto& [name, time] : stages) {
        const double perThread = time.threads > 0 ? 1e9 * time.seconds / static_cast<double>(time.threads) : 0;
        table << std::left << std::setw(24) << name << std::right << std::setw(10) << std::setprecision(3)
              << time.seconds << std::setw(7) << std::setprecision(1) << 100 * time.seconds / total << " %"
              << std::setw(12) << time.dispatches << std::setw(12) << perThread << '\n';
    }
    table << std::left << std::setw(24) << "all stages" << std::right << std::setw(10) << std::setprecision(3) << total
          << std::setw(7) << std::setprecision(1) << 100 * total / std::max(report.renderSeconds, 1e-9)
          << " % of the time between the first pass and the last\n";
    return table.str();
}

} // namespace hyalite::cli
