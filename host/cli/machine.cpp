#include "cli/machine.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace hyalite::cli {

namespace {

// The value of a key of /proc/cpuinfo for the first processor; empty if there is none.
std::string cpuInfo(const std::string& key) {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(':');
        if (line.starts_with(key) && colon != std::string::npos && colon + 2 <= line.size()) {
            return line.substr(colon + 2);
        }
    }
    return {};
}

// The vector instruction sets that a CPU driver may use.
std::string vectorFeatures() {
    constexpr std::array<std::string_view, 8> kWanted{"sse4_1", "sse4_2", "avx",     "avx2",
                                                      "fma",    "f16c",   "avx512f", "asimd"};
    std::string flags = cpuInfo("flags");
    flags += cpuInfo("Features"); // the key on ARM
    std::istringstream words(flags);
    std::string found;
    for (std::string word; words >> word;) {
        if (std::ranges::find(kWanted, word) != kWanted.end()) {
            found += (found.empty() ? "" : " ") + word;
        }
    }
    return found;
}

std::string environment(const char* name) {
    const char* value = std::getenv(name); // NOLINT(concurrency-mt-unsafe): nobody sets it
    return value == nullptr ? std::string() : ", " + std::string(name) + '=' + value;
}

} // namespace

std::vector<std::pair<std::string, std::string>> describeMachine(const gpu::Context& context) {
    const gpu::DeviceInfo& device = context.info();
    std::vector<std::pair<std::string, std::string>> machine{
        {"device", device.name},
        {"driver", device.driver},
        {"subgroup size", std::to_string(device.subgroupSize) + (device.software ? " floats" : "") +
                              environment("LP_NATIVE_VECTOR_WIDTH")},
        {"threads", std::to_string(std::thread::hardware_concurrency()) + environment("LP_NUM_THREADS")},
        {"processor", cpuInfo("model name")},
        {"vector features", vectorFeatures()},
        {"hyalite", HYALITE_VERSION}};
    std::erase_if(machine, [](const auto& entry) { return entry.second.empty(); });
    return machine;
}

} // namespace hyalite::cli
