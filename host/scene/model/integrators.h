// The integrators by name, with all that is known of each without rendering. An integrator is a row here and a row of
// the same name in render/integrators/registry.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite {

// How an integrator continues camera paths at a surface. By default a path ends at a diffuse surface and elsewhere
// follows one randomly selected direction.
struct CameraPathRules {
    bool followsAllWays = false;   // follows both reflection and refraction; max_depth counts these, not segments
    bool bouncesAtDiffuse = false; // continues at diffuse surfaces too
};

struct IntegratorRow {
    std::string_view name; // value of render.integrator
    std::string_view text; // one line, no full stop
    CameraPathRules cameraPaths = {};
    std::array<std::string_view, 20> settings = {}; // the keys of `render` that it reads but some integrators do not

    [[nodiscard]] constexpr bool reads(std::string_view setting) const { // whether `settings` has the key
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

// The row of that name. Throws Error(WrongUsage) if there is none.
[[nodiscard]] const IntegratorRow& integratorNamed(std::string_view name);

// Names of the integrators that read this key of `render`; empty: all integrators read it.
[[nodiscard]] std::vector<std::string> readersOf(std::string_view setting);

// The row of the only integrator that reads this key of `render`; nullptr: all read it, or several.
[[nodiscard]] const IntegratorRow* soleReader(std::string_view setting);

} // namespace hyalite
