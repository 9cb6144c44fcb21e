#include "parity/twins.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hyalite::parity {

namespace {

// In the order of shaders/kernels/README.md.
constexpr auto kTwins = std::to_array<std::pair<std::string_view, TwinFunction>>({
    {"generate_camera_rays", compareGenerateCameraRays},
    {"trace_closest", compareTraceClosest},
    {"shade_surface", compareShadeSurface},
    {"trace_whitted", compareTraceWhitted},
    {"sample_lights", compareSampleLights},
    {"sample_rough_lights", compareSampleRoughLights},
    {"trace_shadow", compareTraceShadow},
    {"bounce_paths", compareBouncePaths},
    {"emit_photons", compareEmitPhotons},
    {"emit_caustic_photons", compareEmitCausticPhotons},
    {"scatter_photon", compareScatterPhoton},
    {"cast_shadow_photons", compareCastShadowPhotons},
    {"scan_group", compareScanGroup},
    {"sum_chunks", compareSumChunks},
    {"scan_chunks", compareScanChunks},
    {"list_next_rays", compareListNextRays},
    {"compact_camera_paths", compareCompactCameraPaths},
    {"compact_photon_paths", compareCompactPhotonPaths},
    {"count_cells", compareCountCells},
    {"fill_cells", compareFillCells},
    {"order_cells", compareOrderCells},
    {"sort_photons", compareSortPhotons},
    {"mark_photons", compareMarkPhotons},
    {"key_photons", compareKeyPhotons},
    {"count_digits", compareCountDigits},
    {"sort_digits", compareSortDigits},
    {"split_nodes", compareSplitNodes},
    {"count_sides", compareCountSides},
    {"part_sides", comparePartSides},
    {"finish_subtrees", compareFinishSubtrees},
    {"place_photons", comparePlacePhotons},
    {"gather_radiance", compareGatherRadiance},
    {"estimate_radiance", compareEstimateRadiance},
    {"begin_irradiance", compareBeginIrradiance},
    {"store_irradiance", compareStoreIrradiance},
    {"look_up_irradiance", compareLookUpIrradiance},
    {"classify_visibility", compareClassifyVisibility},
    {"skip_shadow_rays", compareSkipShadowRays},
    {"start_gather_rays", compareStartGatherRays},
    {"show_surface", compareShowSurface},
    {"splat_photons", compareSplatPhotons},
    {"sum_paths", compareSumPaths},
    {"add_gathered_light", compareAddGatheredLight},
    {"accumulate_film", compareAccumulateFilm},
    {"resolve_film", compareResolveFilm},
    {"estimate_error", compareEstimateError},
});

} // namespace

TwinFunction twinOf(std::string_view kernel) {
    const auto found = std::ranges::find(kTwins, kernel, [](const auto& twin) { return twin.first; });
    return found == kTwins.end() ? nullptr : found->second;
}

} // namespace hyalite::parity
