// Counters of a render. A new counter is one name and one row here: sums, checkpoints and both forms of the report
// follow from the table.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace hyalite::render {

enum class Counter : std::uint8_t {
    CameraRays,
    ShadowRays,
    PhotonRays,
    PhotonsEmitted,
    PhotonsStored,
    ShadowRaysSaved,
    CausticPhotonsEmitted,
    CausticPhotonsStored,
    GatheringRays,
};

struct CounterRow {
    Counter counter;
    std::string_view key;                               // in JSON reports and checkpoints
    std::string_view text;                              // in printed reports
    std::array<std::optional<Counter>, 2> shareOf = {}; // printed as a share of the sum of these
};

inline constexpr std::array kCounters{
    CounterRow{Counter::CameraRays, "camera_rays", "camera rays"},
    CounterRow{Counter::ShadowRays, "shadow_rays", "shadow rays"},
    CounterRow{Counter::PhotonRays, "photon_rays", "photon rays"},
    CounterRow{Counter::PhotonsEmitted, "photons_emitted", "photons emitted"},
    CounterRow{Counter::PhotonsStored, "photons_stored", "photons stored"},
    // Shadow rays that shadow photons replaced
    CounterRow{Counter::ShadowRaysSaved,
               "shadow_rays_saved",
               "shadow rays saved",
               {Counter::ShadowRays, Counter::ShadowRaysSaved}},
    // Caustic map only
    CounterRow{Counter::CausticPhotonsEmitted, "caustic_photons_emitted", "caustic photons emitted"},
    CounterRow{Counter::CausticPhotonsStored,
               "caustic_photons_stored",
               "caustic photons stored",
               {Counter::CausticPhotonsEmitted}},
    // Part of the camera rays: those of final gathering, the cost of render.gather_rays
    CounterRow{Counter::GatheringRays, "gathering_rays", "gathering rays", {Counter::CameraRays}},
};

static_assert(
    [] {
        for (std::size_t i = 0; i < kCounters.size(); ++i) {
            if (static_cast<std::size_t>(kCounters.at(i).counter) != i) {
                return false;
            }
        }
        return true;
    }(),
    "rows are in the order of the names");

// Sums over all passes so far; all zero at first.
class Counts {
public:
    [[nodiscard]] std::uint64_t& operator[](Counter counter) { return values_.at(static_cast<std::size_t>(counter)); }
    [[nodiscard]] std::uint64_t operator[](Counter counter) const {
        return values_.at(static_cast<std::size_t>(counter));
    }

    Counts& operator+=(const Counts& more) {
        for (std::size_t i = 0; i < values_.size(); ++i) {
            values_.at(i) += more.values_.at(i);
        }
        return *this;
    }

private:
    std::array<std::uint64_t, kCounters.size()> values_{};
};

} // namespace hyalite::render
