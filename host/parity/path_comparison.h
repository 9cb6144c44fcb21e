// Whole paths of both sides, vertex by vertex: where they part first, and why.
#pragma once

#include "parity/path_recorder.h"
#include "parity/twin_paths.h"

#include <map>
#include <string>
#include <vector>

namespace hyalite::parity {

// Positions agree within this share of the scene's scale, throughput and flux within this share of themselves.
inline constexpr double kPathTolerance = 1e-4;

// Of all paths, at least this share agrees vertex by vertex.
inline constexpr double kPathShare = 0.999;

// A path on both sides.
struct RecordedPath {
    PathKey key;
    std::vector<DeviceVertex> device;
    std::vector<Vertex> twin;
    std::uint32_t differsAt = 0; // depth of the first vertex that does; 0: none
    std::string what;
    std::string cause;
};

struct PathResult {
    std::uint64_t compared = 0;
    std::uint64_t vertices = 0;
    std::uint64_t agree = 0;
    std::uint64_t storedOnDevice = 0; // photons that the paths left
    std::uint64_t storedByTwin = 0;
    std::map<std::string, std::uint64_t> causes; // of those that do not: how often; "": nothing explains it
    std::vector<RecordedPath> worst;             // unexplained ones first, then those that part earliest

    [[nodiscard]] std::uint64_t unexplained() const;
    [[nodiscard]] double shareThatAgrees() const { return compared == 0 ? 1 : double(agree) / double(compared); }
    [[nodiscard]] bool passed() const { return unexplained() == 0; }
};

struct PathResults {
    PathResult camera;
    PathResult photons;
};

[[nodiscard]] RecordedPath pathOf(const Sides& sides, const PathRecorder& recorder, const PathKey& key);

[[nodiscard]] PathResults comparePaths(const Sides& sides, const PathRecorder& recorder);

} // namespace hyalite::parity
