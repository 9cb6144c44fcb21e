#include "cli/render_report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

namespace hyalite::cli {

namespace {

nlohmann::ordered_json colorOf(const glm::dvec3& c) {
    return {c.x, c.y, c.z};
}

double mean(const glm::dvec3& c) {
    return (c.x + c.y + c.z) / 3;
}

std::string threeDigits(double value) {
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
}

// ", 12 pixels: no light found yet"; empty if there are none.
std::string darkText(const RenderReport& report) {
    const std::uint32_t dark = report.errorEstimate.darkPixels;
    return dark == 0 ? "" : ", " + std::to_string(dark) + (dark == 1 ? " pixel" : " pixels") + ": no light found yet";
}

} // namespace

bool targetErrorMet(const RenderReport& report) {
    return report.errorEstimate.error && *report.errorEstimate.error <= report.targetError;
}

void warnOfTarget(RenderReport& report) {
    if (report.targetError > 0 && !targetErrorMet(report)) {
        const std::optional<double>& error = report.errorEstimate.error;
        const std::string found = error ? "the estimated error is " + threeDigits(*error) : "there is no estimate";
        report.notes.warnings.push_back("the target error of " + threeDigits(report.targetError) +
                                        " was not reached: " + found + " after " + std::to_string(report.passes) +
                                        (report.passes == 1 ? " pass" : " passes") + darkText(report) +
                                        " (allow more --passes or --time)");
    }
}

std::string errorText(const RenderReport& report) {
    if (!report.errorEstimate.error) {
        return darkText(report);
    }
    const std::string text = ", estimated error " + threeDigits(*report.errorEstimate.error);
    if (report.targetError <= 0) {
        return text + darkText(report);
    }
    return text + " (target " + threeDigits(report.targetError) + (targetErrorMet(report) ? " met)" : " not met)") +
           darkText(report);
}

std::string jsonReport(const RenderReport& report) {
    nlohmann::ordered_json object;
    object["version"] = HYALITE_VERSION;
    object["scene"] = report.scene;
    object["integrator"] = report.integrator;
    object["backend"] = report.backend;
    object["device"] = report.device;
    object["seed"] = report.seed;
    object["sampler"] = report.sampler;
    object["resolution"] = {report.resolution.x, report.resolution.y};
    object["passes"] = report.passes;
    if (report.resumedFrom > 0) {
        object["resumed_from"] = report.resumedFrom;
    }
    object["interrupted"] = report.interrupted;
    const ErrorEstimate& estimate = report.errorEstimate;
    object["error_estimate"] = estimate.error ? nlohmann::ordered_json(*estimate.error) : nullptr;
    object["pixels_without_light"] = estimate.darkPixels;
    if (report.targetError > 0) {
        object["target_error"] = report.targetError;
        object["target_error_met"] = targetErrorMet(report);
    }
    object["seconds"] = {
        {"total", report.totalSeconds}, {"setup", report.setupSeconds}, {"render", report.renderSeconds}};
    if (!report.memory.empty()) {
        object["buffer_bytes"] = report.memory;
    }
    if (report.counts) {
        for (const render::CounterRow& row : render::kCounters) {
            object["counts"][row.key] = (*report.counts)[row.counter];
        }
    }
    for (const render::LightBalance& light : report.notes.lights) {
        object["lights"].push_back({{"emitted", colorOf(light.emitted)},
                                    {"stored", colorOf(light.stored)},
                                    {"absorbed", colorOf(light.absorbed)},
                                    {"escaped", colorOf(light.escaped)},
                                    {"cut_off", colorOf(light.cutOff)}});
    }
    if (report.notes.searchRadius > 0) {
        object["search_radius"] = report.notes.searchRadius;
    }
    if (report.notes.causticSearchRadius > 0) {
        object["caustic_search_radius"] = report.notes.causticSearchRadius;
    }
    object["warnings"] = report.sceneWarnings;
    for (const std::string& warning : report.notes.warnings) {
        object["warnings"].push_back(warning);
    }
    for (const auto& [name, time] : report.stages) {
        object["stages"][name] = {
            {"seconds", time.seconds}, {"dispatches", time.dispatches}, {"threads", time.threads}};
    }
    object["outputs"] = report.outputs;
    return object.dump(2);
}

Metadata pictureMetadata(const RenderReport& report) {
    return {
        {"software", "hyalite " HYALITE_VERSION}, {"scene", std::filesystem::path(report.scene).filename().string()},
        {"integrator", report.integrator},        {"backend", report.backend},
        {"seed", std::to_string(report.seed)},    {"sampler", report.sampler},
        {"passes", std::to_string(report.passes)}};
}

void writePictures(const std::vector<std::string>& outputs, const LayeredImage& image, bool layers,
                   const Metadata& metadata) {
    std::vector<Layer> written{{"", image.picture}};
    for (const NamedImage& layer : image.layers) {
        if (layers) {
            written.push_back({layer.name, layer.image});
        }
    }
    if (layers && image.error) {
        written.push_back({"error", *image.error});
    }
    for (const std::string& output : outputs) {
        writeImage(output, written, metadata);
    }
}

void printReport(const RenderReport& report, const ReportStyle& style) {
    if (style.json) {
        std::cout << jsonReport(report) << '\n';
        return;
    }
    if (style.profile) {
        std::cout << stageTable(report) << memoryTable(report) << lightTable(report) << countTable(report);
    }
    if (!style.quiet) {
        for (const std::string& output : report.outputs) {
            std::cout << std::filesystem::absolute(output).lexically_normal().string() << ": " << report.resolution.x
                      << " x " << report.resolution.y << ", " << report.passes
                      << (report.passes == 1 ? " pass in " : " passes in ") << std::round(10 * report.totalSeconds) / 10
                      << " s" << errorText(report) << '\n';
        }
    }
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

std::string memoryTable(const RenderReport& report) {
    std::vector<std::pair<std::string, std::size_t>> buffers(report.memory.begin(), report.memory.end());
    std::ranges::sort(buffers, [](const auto& a, const auto& b) { return a.second > b.second; });
    const auto total = std::accumulate(buffers.begin(), buffers.end(), std::size_t{0},
                                       [](std::size_t sum, const auto& buffer) { return sum + buffer.second; });
    const auto mebibytes = [](std::size_t bytes) { return static_cast<double>(bytes) / (1024.0 * 1024.0); };
    std::ostringstream table;
    table << std::fixed << std::setprecision(1) << std::left << std::setw(24) << "buffer" << std::right << std::setw(10)
          << "MiB" << '\n';
    for (const auto& [name, bytes] : buffers) {
        if (100 * bytes >= total) {
            table << std::left << std::setw(24) << name << std::right << std::setw(10) << mebibytes(bytes) << '\n';
        }
    }
    table << std::left << std::setw(24) << "all buffers" << std::right << std::setw(10) << mebibytes(total)
          << "  (buffers below 1 % are not listed)\n";
    return table.str();
}

std::string lightTable(const RenderReport& report) {
    if (report.notes.lights.empty()) {
        return {};
    }
    std::ostringstream table;
    table << std::fixed << std::setprecision(4) << "light, mean of channels [W]     emitted      stored    absorbed"
          << "     escaped     cut off\n";
    for (std::size_t i = 0; i < report.notes.lights.size(); ++i) {
        const render::LightBalance& light = report.notes.lights[i];
        table << std::left << std::setw(27) << i << std::right;
        for (const glm::dvec3& flux : {light.emitted, light.stored, light.absorbed, light.escaped, light.cutOff}) {
            table << std::setw(12) << mean(flux);
        }
        table << '\n';
    }
    return table.str();
}

std::string countTable(const RenderReport& report) {
    if (!report.counts) {
        return {};
    }
    const render::Counts& counts = *report.counts;
    std::ostringstream table;
    table << std::fixed << std::setprecision(1);
    for (const render::CounterRow& row : render::kCounters) {
        std::uint64_t whole = 0;
        for (const auto& part : row.shareOf) {
            whole += part ? counts[*part] : 0;
        }
        if (whole > 0) {
            table << row.text << ": " << counts[row.counter] << " of " << whole << ", "
                  << 100 * static_cast<double>(counts[row.counter]) / static_cast<double>(whole) << " %\n";
        } else if (counts[row.counter] > 0) {
            table << row.text << ": " << counts[row.counter] << '\n';
        }
    }
    return table.str();
}

} // namespace hyalite::cli
