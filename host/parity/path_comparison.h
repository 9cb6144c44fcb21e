// Whole paths of both sides, vertex by vertex: where they part first, and why.
#pragma once

#include "parity/comparison.h"
#include "parity/path_recorder.h"
#include "parity/step_comparison.h"
#include "parity/twin_path.h"

#include <map>
#include <string>
#include <vector>

namespace hyalite::parity {

// What becomes of a path that is followed from its start on both sides, where every step by itself agrees.
inline constexpr const char* kGrown = "roundings that grew along the path";

// A path on both sides.
struct RecordedPath {
    PathKey key;
    std::vector<DeviceVertex> device;
    std::vector<Vertex> twin;
    std::uint32_t differsAt = 0; // depth of the first vertex that does; 0: none
    std::string what;            // differs there first
    // kGrown; or why the first step differs where the twin goes on from the device's own ray. Empty: no few roundings
    // explain it.
    std::string cause;
};

// Photons that paths left.
struct PhotonSum {
    std::uint64_t count = 0;
    glm::dvec3 flux{0}; // [W]
};

struct PathResult {
    std::uint64_t compared = 0;
    std::uint64_t vertices = 0;
    std::uint64_t agree = 0; // from the start, vertex by vertex
    PhotonSum storedOnDevice;
    PhotonSum storedByTwin;
    std::map<std::string, std::uint64_t> causes; // of those that do not: how often; "": nothing explains it
    std::vector<RecordedPath> worst;             // unexplained ones first, then those that part earliest

    [[nodiscard]] std::uint64_t unexplained() const;
    [[nodiscard]] std::uint64_t agreeStepwise() const; // each vertex follows from the one before as the device has it
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
