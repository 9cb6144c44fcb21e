// The list of all checks. For a new kernel, add a file to this folder, and its name here and in checks.cpp.
#pragma once

#include "parity/check.h"

#include <span>
#include <string_view>

namespace hyalite::parity {

// In the order of shaders/kernels/README.md.
extern const Check kGenerateCameraRays;
extern const Check kTraceClosest;
extern const Check kShadeSurface;
extern const Check kTraceWhitted;
extern const Check kSampleLights;
extern const Check kSampleRoughLights;
extern const Check kTryLights;
extern const Check kTraceShadow;
extern const Check kBouncePaths;
extern const Check kEmitPhotons;
extern const Check kEmitCausticPhotons;
extern const Check kScatterPhoton;
extern const Check kCastShadowPhotons;
extern const Check kScanGroup;
extern const Check kSumChunks;
extern const Check kScanChunks;
extern const Check kListNextRays;
extern const Check kCompactPaths;
extern const Check kCountCells;
extern const Check kFillCells;
extern const Check kOrderCells;
extern const Check kSortPhotons;
extern const Check kMarkPhotons;
extern const Check kKeyPhotons;
extern const Check kCountDigits;
extern const Check kSortDigits;
extern const Check kSplitNodes;
extern const Check kCountSides;
extern const Check kPartSides;
extern const Check kFinishSubtrees;
extern const Check kPlacePhotons;
extern const Check kGatherRadiance;
extern const Check kEstimateRadiance;
extern const Check kBeginIrradiance;
extern const Check kStoreIrradiance;
extern const Check kLookUpIrradiance;
extern const Check kClassifyVisibility;
extern const Check kSkipShadowRays;
extern const Check kStartGatherRays;
extern const Check kShowSurface;
extern const Check kSplatPhotons;
extern const Check kSumPaths;
extern const Check kAddGatheredLight;
extern const Check kAccumulateFilm;
extern const Check kResolveFilm;
extern const Check kEstimateError;

[[nodiscard]] std::span<const Check* const> allChecks();

// nullptr: the kernel has no check.
[[nodiscard]] const Check* checkOf(std::string_view kernel);

} // namespace hyalite::parity
