#include "parity/checks/checks.h"

#include <algorithm>
#include <array>

namespace hyalite::parity {

namespace {

constexpr auto kChecks = std::to_array<const Check*>({
    &kGenerateCameraRays, &kTraceClosest,      &kShadeSurface,    &kTraceWhitted,    &kSampleLights,
    &kSampleRoughLights,  &kTraceShadow,       &kBouncePaths,     &kEmitPhotons,     &kEmitCausticPhotons,
    &kScatterPhoton,      &kCastShadowPhotons, &kScanGroup,       &kSumChunks,       &kScanChunks,
    &kListNextRays,       &kCompactPaths,      &kCountCells,      &kFillCells,       &kOrderCells,
    &kSortPhotons,        &kMarkPhotons,       &kKeyPhotons,      &kCountDigits,     &kSortDigits,
    &kSplitNodes,         &kCountSides,        &kPartSides,       &kFinishSubtrees,  &kPlacePhotons,
    &kGatherRadiance,     &kEstimateRadiance,  &kBeginIrradiance, &kStoreIrradiance, &kLookUpIrradiance,
    &kClassifyVisibility, &kSkipShadowRays,    &kStartGatherRays, &kShowSurface,     &kSplatPhotons,
    &kSumPaths,           &kAddGatheredLight,  &kAccumulateFilm,  &kResolveFilm,     &kEstimateError,
    &kTryLights,
});

} // namespace

std::span<const Check* const> allChecks() {
    return kChecks;
}

const Check* checkOf(std::string_view kernel) {
    const auto found = std::ranges::find(kChecks, kernel, &Check::kernel);
    return found == kChecks.end() ? nullptr : *found;
}

} // namespace hyalite::parity
