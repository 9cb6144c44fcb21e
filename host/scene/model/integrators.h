// The integrators as scene files and command lines name them, and what can be said of each without rendering. A row
// here and one of the same name in render/integrators/registry.cpp make an integrator.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite {

// Where the camera paths of an integrator go from a surface. By default they end at diffuse ones, and follow one of
// several directions elsewhere, picked at random.
struct CameraPathRules {
    bool followsAllWays = false;   // reflection and refraction both; max_depth counts these, not the path's segments
    bool bouncesAtDiffuse = false; // on from diffuse surfaces too
};

struct IntegratorRow {
    std::string_view name; // of render.integrator
    std::string_view text; // one line, no full stop
    CameraPathRules cameraPaths = {};
    std::array<std::string_view, 20> settings = {}; // keys of `render` that it reads and not every integrator does

    [[nodiscard]] constexpr bool reads(std::string_view setting) const { // of those keys
        return !setting.empty() && std::ranges::find(settings, setting) != settings.end();
    }
};

// In the order of help texts; the first is the default.
inline constexpr std::array kIntegrators{
    IntegratorRow{.name = "ppm",
                  .text = "progressive photon mapping",
                  .settings = {"photons", "radius", "alpha", "caustic_photons", "caustic_radius", "projection_map"}},
    IntegratorRow{.name = "photonmap",
                  .text = "photon mapping in two passes",
                  .settings = {"photons", "radius", "caustic_photons", "caustic_radius", "projection_map", "structure",
                               "nearest", "caustic_nearest", "filter", "caustic_filter", "cone_constant", "filter_file",
                               "differential_checking", "gather_rays", "precomputed_irradiance", "shadow_photons",
                               "view"}},
    IntegratorRow{.name = "whitted",
                  .text = "recursive ray tracing",
                  .cameraPaths = {.followsAllWays = true},
                  .settings = {"min_weight"}},
    IntegratorRow{.name = "path", .text = "path tracing, unbiased", .cameraPaths = {.bouncesAtDiffuse = true}},
};

inline constexpr auto kIntegratorNames = [] {
    std::array<std::string_view, kIntegrators.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) {
        names.at(i) = kIntegrators.at(i).name;
    }
    return names;
}();

// The row of that name. Throws Error(WrongUsage) where there is none.
[[nodiscard]] const IntegratorRow& integratorNamed(std::string_view name);

// Names of the integrators that read that key of `render`; empty: all of them do.
[[nodiscard]] std::vector<std::string> readersOf(std::string_view setting);

// The row whose integrator alone reads that key of `render`; nullptr: none, or several.
[[nodiscard]] const IntegratorRow* soleReader(std::string_view setting);

} // namespace hyalite
