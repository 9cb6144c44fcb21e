#include "parity/step_comparison.h"

#include "parity/hull.h"
#include "parity/nudge.h"
#include "parity/tolerances.h"

#include <algorithm>

namespace hyalite::parity {

namespace {

class StepComparison {
public:
    // `path`: all vertices on the device. Keeps references.
    StepComparison(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass,
                   const std::vector<DeviceVertex>& path, const DeviceVertex& vertex)
        : sides_(sides), key_(key), pass_(pass), path_(path), vertex_(vertex) {}

    // Cause of the difference. None: the step agrees; empty: rounding does not explain the difference.
    [[nodiscard]] std::optional<std::string> cause() const {
        const std::string what = difference(step(Nudge(0)));
        if (what.empty()) {
            return std::nullopt;
        }
        if (!isExplained()) {
            return "";
        }
        if (what == "object") {
            return std::string(kEdge);
        }
        return std::string(what == "choice" ? kDecision : kGrazing);
    }

private:
    // Numerical results of one step: a position, and the direction and weight of each next ray.
    struct Numbers {
        glm::dvec3 value;
        double tolerance;
    };

    [[nodiscard]] PathStep step(Nudge nudge) const {
        PathState state = stateBefore(sides_, key_, vertex_);
        state.ray.origin = nudge.point(state.ray.origin, sides_.scale());
        state.ray.direction = nudge.direction(state.ray.direction);
        std::optional<reference::Hit> hit = sides_.trace(state.ray, vertex_.ray.from);
        const std::optional<reference::Hit> device = sides_.toTwin(vertex_.hit);
        if ((!nudge.movesNothing() || sides_.touch(device, hit)) &&
            sides_.areInOnePlace(sides_.toTwin(vertex_.ray), device, hit)) {
            hit = device;
        }
        return stepOf(sides_, key_, pass_, state, hit);
    }

    // The device's next vertex, if it was recorded.
    [[nodiscard]] const DeviceVertex* following(const PathState& next) const {
        const auto found = std::ranges::find_if(path_, [&](const DeviceVertex& v) {
            return v.depth == next.depth && (key_.isPhoton || v.seed == next.camera.samplerSeed);
        });
        return found == path_.end() ? nullptr : &*found;
    }

    [[nodiscard]] bool sameDecisions(const PathStep& step) const {
        const auto goesOnAlike = [&](const PathState& next) {
            if (key_.isPhoton && next.depth >= sides_.world().render.maxDepth) {
                return true; // the last segment of the longest path belongs to the camera
            }
            const DeviceVertex* v = following(next);
            return v != nullptr && v->media == sides_.numberOf(key_.isPhoton ? next.photon.media : next.camera.media);
        };
        return step.vertex.object == vertex_.object && step.vertex.choice == vertex_.choice &&
               std::ranges::all_of(step.next, goesOnAlike);
    }

    [[nodiscard]] std::vector<Numbers> numbersOf(const PathStep& step) const {
        // A lobe may pass on a small share of what arrived, accurate relative to what arrived
        const double arriving = largestComponent(vertex_.weight);
        std::vector<Numbers> numbers{{step.vertex.position, kPathTolerance * sides_.scale()}};
        for (const PathState& next : step.next) {
            const glm::dvec3 weight = key_.isPhoton ? next.photon.power : next.camera.beta;
            numbers.push_back({next.ray.direction, kPathTolerance});
            numbers.push_back({weight, kPathTolerance * std::max(arriving, largestComponent(weight))});
        }
        return numbers;
    }
    // The device's numbers, in the order of numbersOf(step); the step's where the device recorded none.
    [[nodiscard]] std::vector<glm::dvec3> deviceNumbers(const PathStep& step) const {
        std::vector<glm::dvec3> numbers{vertex_.position};
        for (const PathState& next : step.next) {
            const DeviceVertex* v = following(next);
            numbers.push_back(v != nullptr ? v->direction : next.ray.direction);
            numbers.push_back(v != nullptr ? v->weight : key_.isPhoton ? next.photon.power : next.camera.beta);
        }
        return numbers;
    }

    [[nodiscard]] std::string difference(const PathStep& step) const {
        if (step.vertex.object != vertex_.object) {
            return "object";
        }
        if (!sameDecisions(step)) {
            return "choice";
        }
        const std::vector<Numbers> twin = numbersOf(step);
        const std::vector<glm::dvec3> device = deviceNumbers(step);
        for (std::size_t i = 0; i < twin.size(); ++i) {
            if (largestComponent(device[i] - twin[i].value) > twin[i].tolerance) {
                return "number";
            }
        }
        return {};
    }

    // True if the twin, for rays a few roundings away, makes the device's choices, and its numbers enclose the
    // device's.
    [[nodiscard]] bool isExplained() const {
        std::vector<Hull> hulls;
        std::optional<PathStep> alike;
        for (std::uint32_t n = 0; n <= kMoreNudges; ++n) {
            const PathStep nudged = step(Nudge(n));
            if (!sameDecisions(nudged)) {
                continue;
            }
            const std::vector<Numbers> numbers = numbersOf(nudged);
            hulls.resize(numbers.size());
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                hulls[i].add(numbers[i].value);
            }
            alike = nudged;
        }
        if (!alike) {
            return false;
        }
        const std::vector<Numbers> twin = numbersOf(*alike);
        const std::vector<glm::dvec3> device = deviceNumbers(*alike);
        for (std::size_t i = 0; i < twin.size(); ++i) {
            if (!hulls[i].holds(device[i], twin[i].tolerance)) {
                return false;
            }
        }
        return true;
    }

    const Sides& sides_;
    const PathKey& key_;
    const reference::PhotonPass& pass_;
    const std::vector<DeviceVertex>& path_;
    const DeviceVertex& vertex_;
};

} // namespace

std::optional<std::string> causeOfDifference(const Sides& sides, const PathKey& key, const reference::PhotonPass& pass,
                                             const std::vector<DeviceVertex>& path, const DeviceVertex& vertex) {
    return StepComparison(sides, key, pass, path, vertex).cause();
}

} // namespace hyalite::parity
