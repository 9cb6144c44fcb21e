#include "parity/path_comparison.h"

#include "parity/hull.h"
#include "parity/nudge.h"
#include "parity/step_comparison.h"

#include <algorithm>
#include <cmath>

namespace hyalite::parity {

namespace {

constexpr std::size_t kWorstKept = 32; // per kind of path

double relativeTo(const glm::dvec3& a, const glm::dvec3& b, double scale) {
    return largestComponent(a - b) / std::max({scale, largestComponent(b), 1e-30});
}

// Do the vertices lie at the same point of surfaces that touch? Rounding decides which of these is hit.
bool areInOnePlace(const Sides& sides, const Vertex& device, const Vertex& twin) {
    return device.object != shared::kNone && twin.object != shared::kNone &&
           relativeTo(device.position, twin.position, sides.scale()) <= kPathTolerance &&
           std::abs(glm::dot(device.normal, twin.normal)) >= 1 - kPathTolerance;
}

// The first quantity that differs at a vertex, in the order of computation; empty: nothing differs.
std::string differenceAt(const Sides& sides, const Vertex& device, const Vertex& twin) {
    if (device.object != twin.object && !areInOnePlace(sides, device, twin)) {
        return "object";
    }
    if (relativeTo(device.position, twin.position, sides.scale()) > kPathTolerance) {
        return "position";
    }
    if (device.media != twin.media) {
        return "medium";
    }
    if (relativeTo(device.weight, twin.weight, 0) > kPathTolerance) {
        return "weight";
    }
    return device.choice != twin.choice ? "choice" : "";
}

void keep(PathResult& result, RecordedPath path) {
    const auto rank = [](const RecordedPath& p) { return std::pair(!p.cause.empty(), p.differsAt); };
    result.worst.insert(std::ranges::upper_bound(result.worst, rank(path), {}, rank), std::move(path));
    if (result.worst.size() > kWorstKept) {
        result.worst.pop_back();
    }
}

// First difference of two paths, each followed from its start.
struct Difference {
    std::uint32_t depth = 0;
    std::string what;
};

std::optional<Difference> differenceOf(const Sides& sides, const std::vector<DeviceVertex>& device,
                                       const std::vector<Vertex>& twin) {
    for (const Vertex& expected : twin) {
        const auto isSame = [&](const Vertex& v) { return v.seed == expected.seed && v.depth == expected.depth; };
        const auto found = std::ranges::find_if(device, isSame);
        // A missing vertex results from an earlier choice
        const std::string what = found == device.end() ? "choice" : differenceAt(sides, *found, expected);
        if (!what.empty()) {
            return Difference{expected.depth, what};
        }
    }
    if (device.size() > twin.size()) {
        return Difference{device.back().depth, "choice"};
    }
    return std::nullopt;
}

// From the scene's coordinates to those of the world, in which paths are shown.
template <class Vertices>
void toWorld(Vertices& path, const glm::dvec3& origin) {
    for (Vertex& vertex : path) {
        vertex.from += origin;
        if (vertex.object != shared::kNone) {
            vertex.position += origin;
        }
    }
}

// True if both sides start with the same ray, up to a few roundings of the random numbers.
bool startsAlike(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass, const Vertex& device) {
    Hull origin;
    Hull direction;
    Hull weight;
    for (std::uint32_t n = 0; n <= kNudges; ++n) {
        const PathState twin = firstState(sides, key, pass, Nudge(n));
        origin.add(twin.ray.origin);
        direction.add(twin.ray.direction);
        weight.add(key.isPhoton ? twin.photon.power : twin.camera.beta);
    }
    return origin.holds(device.from, kPathTolerance * sides.scale()) &&
           direction.holds(device.direction, kPathTolerance) &&
           weight.holds(device.weight, kPathTolerance * largestComponent(weight.high()));
}

// See RecordedPath.
std::string causeOf(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass,
                    const std::vector<DeviceVertex>& device) {
    if (device.empty() || !startsAlike(sides, key, pass, device.front())) {
        return "";
    }
    for (const DeviceVertex& vertex : device) {
        if (auto cause = causeOfDifference(sides, key, pass, device, vertex)) {
            return *std::move(cause);
        }
    }
    return kGrown;
}

template <class Vertices>
void addStored(PhotonSum& sum, const Vertices& path) {
    for (const Vertex& vertex : path) {
        if ((vertex.choice & kStored) != 0) {
            ++sum.count;
            sum.flux += vertex.weight;
        }
    }
}

} // namespace

std::uint64_t PathResult::unexplained() const {
    const auto found = causes.find("");
    return found == causes.end() ? 0 : found->second;
}

std::uint64_t PathResult::agreeStepwise() const {
    const auto grown = causes.find(kGrown);
    return agree + (grown == causes.end() ? 0 : grown->second);
}

RecordedPath pathOf(const Sides& sides, const PathRecorder& recorder, const PathKey& key) {
    RecordedPath path{.key = key, .device = {}, .twin = {}, .differsAt = 0, .what = {}, .cause = {}};
    const auto found = recorder.paths().find(key);
    if (found != recorder.paths().end()) {
        path.device = found->second;
    }
    const auto pass = key.isPhoton ? recorder.photonPasses().at(key.sequence).pass : reference::PhotonPass{};
    path.twin = twinPath(sides, key, pass);
    if (const auto difference = differenceOf(sides, path.device, path.twin)) {
        path.differsAt = difference->depth;
        path.what = difference->what;
        path.cause = causeOf(sides, key, pass, path.device);
    }
    toWorld(path.device, sides.world().origin);
    toWorld(path.twin, sides.world().origin);
    return path;
}

PathResults comparePaths(const Sides& sides, const PathRecorder& recorder) {
    PathResults results;
    for (const auto& [key, vertices] : recorder.paths()) {
        RecordedPath path = pathOf(sides, recorder, key);
        PathResult& result = key.isPhoton ? results.photons : results.camera;
        ++result.compared;
        result.vertices += path.twin.size();
        addStored(result.storedOnDevice, path.device);
        addStored(result.storedByTwin, path.twin);
        if (path.differsAt == 0) {
            ++result.agree;
        } else {
            ++result.causes[path.cause];
            keep(result, std::move(path));
        }
    }
    return results;
}

} // namespace hyalite::parity
