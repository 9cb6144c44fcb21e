#include "parity/path_comparison.h"

#include "parity/nudge.h"

#include <algorithm>

namespace hyalite::parity {

namespace {

constexpr std::size_t kWorstKept = 32; // of each kind of path

double relativeTo(const glm::dvec3& a, const glm::dvec3& b, double scale) {
    return largestComponent(a - b) / std::max({scale, largestComponent(b), 1e-30});
}

// What differs at a vertex first, in the order in which a path is computed; empty: nothing.
std::string differenceAt(const Sides& sides, const Vertex& device, const Vertex& twin) {
    if (device.object != twin.object) {
        return "object";
    }
    if (relativeTo(device.position, twin.position, sides.scale()) > kPathTolerance) {
        return "position";
    }
    if (device.medium != twin.medium) {
        return "medium";
    }
    if (relativeTo(device.weight, twin.weight, 0) > kPathTolerance) {
        return "weight";
    }
    return device.choice != twin.choice ? "choice" : "";
}

// What the twin does with the device's own ray, moved by a few roundings, at a vertex.
Vertex twinVertex(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass, const DeviceVertex& device,
                  Nudge nudge) {
    reference::Ray ray = sides.toTwin(device.ray);
    ray.origin = nudge.point(ray.origin, sides.scale());
    ray.direction = nudge.direction(ray.direction);
    Vertex vertex = device;
    vertex.object = shared::kNone;
    vertex.position = glm::dvec3(0);
    vertex.choice = 0;
    const auto hit = sides.trace(ray, device.ray.from);
    if (!hit) {
        return vertex;
    }
    const reference::Surface surface = reference::evaluateSurface(sides.world(), ray, *hit);
    const auto wayOn = [&](const glm::dvec3& d) {
        return glm::dot(d, surface.geometricNormal) < 0 ? kTransmitted : kReflected;
    };
    vertex.object = hit->object;
    vertex.position = surface.position;
    const auto* medium = device.medium == shared::kNone ? nullptr : &sides.world().materials.at(device.medium);
    if (key.isPhoton) {
        const reference::PhotonPath path{
            .power = device.weight, .photon = key.number, .kind = reference::PhotonKind::Indirect, .medium = medium};
        const auto scatter = reference::scatterPhoton(sides.world(), ray, *hit, path, device.depth, pass);
        vertex.choice = device.choice & kStored; // by the kind of the photon, which no rounding changes
        vertex.choice |= scatter.next ? wayOn(scatter.next->direction) : 0;
        return vertex;
    }
    const reference::CameraPath path{
        .beta = device.weight, .samplerSeed = device.seed, .medium = medium, .pdfW = device.pdfW};
    const auto shading = reference::shadeSurface(sides.world(), ray, *hit, path, device.depth, key.sequence);
    vertex.choice = shading.visible ? kDiffuseEnd : 0;
    for (const auto& next : shading.next) {
        vertex.choice |= next ? wayOn(next->ray.direction) : 0;
    }
    return vertex;
}

// Up to here the paths agree, to within rounding that has grown along them. Does the twin, given the device's own ray
// or one a few roundings away, do as the device does? Then the two rays passed on either side of what decides.
std::string causeOf(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass,
                    const DeviceVertex& device, const std::string& what) {
    if (what == "medium" || what == "weight") {
        return "grazing or ill-conditioned"; // carried over from the vertex before, where every stage is compared
    }
    for (std::uint32_t n = 0; n <= kNudges; ++n) {
        const Vertex twin = twinVertex(sides, key, pass, device, Nudge(n));
        const std::string rest = differenceAt(sides, device, twin);
        if (what == "object" && rest != "object") {
            return "edge, silhouette, or surfaces in one place";
        }
        if (what == "position" && rest != "object" && rest != "position") {
            return "grazing or ill-conditioned";
        }
        if (what == "choice" && rest.empty()) {
            return "coin at its threshold";
        }
    }
    return {};
}

void keep(PathResult& result, RecordedPath path) {
    const auto rank = [](const RecordedPath& p) { return std::pair(!p.cause.empty(), p.differsAt); };
    result.worst.insert(std::ranges::upper_bound(result.worst, rank(path), {}, rank), std::move(path));
    if (result.worst.size() > kWorstKept) {
        result.worst.pop_back();
    }
}

// Where two paths part, and why.
struct Difference {
    std::uint32_t depth = 0;
    std::string what;
    std::string cause;
};

std::optional<Difference> differenceOf(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass,
                                       const std::vector<DeviceVertex>& device, const std::vector<Vertex>& twin) {
    for (const Vertex& expected : twin) {
        const auto isSame = [&](const Vertex& v) { return v.seed == expected.seed && v.depth == expected.depth; };
        const auto found = std::ranges::find_if(device, isSame);
        // A vertex that is missing follows from a choice before it
        const std::string what = found == device.end() ? "choice" : differenceAt(sides, *found, expected);
        if (!what.empty()) {
            const std::string cause = found == device.end() ? "" : causeOf(sides, key, pass, *found, what);
            return Difference{expected.depth, what, cause};
        }
    }
    if (device.size() > twin.size()) {
        return Difference{device.back().depth, "choice", {}};
    }
    return std::nullopt;
}

} // namespace

std::uint64_t PathResult::unexplained() const {
    const auto found = causes.find("");
    return found == causes.end() ? 0 : found->second;
}

RecordedPath pathOf(const Sides& sides, const PathRecorder& recorder, const PathKey& key) {
    RecordedPath path{.key = key, .device = {}, .twin = {}, .differsAt = 0, .what = {}, .cause = {}};
    const auto found = recorder.paths().find(key);
    if (found != recorder.paths().end()) {
        path.device = found->second;
    }
    const auto pass = key.isPhoton ? recorder.photonPasses().at(key.sequence).pass : reference::PhotonPass{};
    path.twin =
        key.isPhoton ? twinPhotonPath(sides, key.number, pass) : twinCameraPath(sides, key.number, key.sequence);
    if (const auto difference = differenceOf(sides, key, pass, path.device, path.twin)) {
        path.differsAt = difference->depth;
        path.what = difference->what;
        path.cause = difference->cause;
    }
    return path;
}

PathResults comparePaths(const Sides& sides, const PathRecorder& recorder) {
    PathResults results;
    for (const auto& [key, vertices] : recorder.paths()) {
        RecordedPath path = pathOf(sides, recorder, key);
        PathResult& result = key.isPhoton ? results.photons : results.camera;
        ++result.compared;
        result.vertices += path.twin.size();
        const auto isStored = [](const Vertex& vertex) { return (vertex.choice & kStored) != 0; };
        result.storedOnDevice += static_cast<std::uint64_t>(std::ranges::count_if(path.device, isStored));
        result.storedByTwin += static_cast<std::uint64_t>(std::ranges::count_if(path.twin, isStored));
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
