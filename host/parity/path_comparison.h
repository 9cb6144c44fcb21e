// Compares whole paths of both sides vertex by vertex: where they first differ, and why.
#pragma once

#include "parity/comparison.h"
#include "parity/path_recorder.h"
#include "parity/step_comparison.h"
#include "parity/twin_path.h"

#include <map>
#include <string>
#include <vector>

namespace hyalite::parity {

// Cause of a difference between paths followed from their starts, if every single step agrees.
inline constexpr const char* kGrown = "rounding amplified along the path";

// A path on both sides.
struct RecordedPath {
    PathKey key;
    std::vector<DeviceVertex> device;
    std::vector<Vertex> twin;
    std::uint32_t differsAt = 0; // depth of the first vertex that differs; 0: none
    std::string what;            // quantity that differs there first
    // kGrown, or why a step differs: the first step where the twin, continuing from the device's own ray, disagrees.
    // Empty: rounding does not explain it.
    std::string cause;
};

// Photons stored along the paths.
struct PhotonSum {
    std::uint64_t count = 0;
    glm::dvec3 flux{0}; // [W]
};

struct PathResult {
    std::uint64_t compared = 0;
    std::uint64_t vertices = 0;
    std::uint64_t agree = 0; // number of paths that agree from their start, vertex by vertex
    PhotonSum storedOnDevice;
    PhotonSum storedByTwin;
    std::map<std::string, std::uint64_t> causes; // count per cause of the paths that differ; "": unexplained
    std::vector<RecordedPath> worst;             // unexplained ones first, then those that differ earliest

    [[nodiscard]] std::uint64_t unexplained() const;
    [[nodiscard]] std::uint64_t agreeStepwise() const; // every step agrees when started from the device's vertex
    [[nodiscard]] double share() const { return shareOf(agree); }
    [[nodiscard]] double shareStepwise() const { return shareOf(agreeStepwise()); }
    [[nodiscard]] bool passed() const { return unexplained() == 0 && 1 - shareStepwise() <= kMostApart; }

private:
    [[nodiscard]] double shareOf(std::uint64_t n) const { return compared == 0 ? 1 : double(n) / double(compared); }
};

struct PathResults {
    PathResult camera;
    PathResult photons;
};

[[nodiscard]] RecordedPath pathOf(const Sides& sides, const PathRecorder& recorder, const PathKey& key);

[[nodiscard]] PathResults comparePaths(const Sides& sides, const PathRecorder& recorder);

} // namespace hyalite::parity
