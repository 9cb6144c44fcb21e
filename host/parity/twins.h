// The twin of every kernel: given what a dispatch read, compares what it wrote with what the reference says.
#pragma once

#include "parity/comparison.h"
#include "parity/observed.h"
#include "parity/sides.h"

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace hyalite::parity {

// For records that are copied, not computed.
template <class T>
[[nodiscard]] bool sameBits(const T& a, const T& b) {
    return std::ranges::equal(std::as_bytes(std::span(&a, 1)), std::as_bytes(std::span(&b, 1)));
}

// What a comparison of one dispatch sees and fills. `where` names the dispatch; threads are added to it.
struct Stage {
    const Sides& sides;
    const Observed& seen;
    Comparison& comparison;
    std::string where;

    // Compares the element that thread `i` answers for.
    Outcome compare( // NOLINT(modernize-use-nodiscard): few ask
        std::size_t i, const Answer& device, const Comparison::Twin& twin,
        const Comparison::Inputs& inputs = [] { return OffenderInputs(); }) const {
        return comparison.compare(where, i, device, twin, inputs);
    }
    // NOLINTNEXTLINE(modernize-use-nodiscard): likewise
    Outcome compareExact(std::size_t i, const Answer& device, const Answer& expected) const {
        return comparison.compareExact(where, i, device, expected);
    }
};

// One element of generate_camera_rays, of trace_closest: of kernels that do more than these, too.
void compareCameraRay(const Stage& stage, std::size_t i, std::uint32_t pixel, std::uint32_t pass,
                      const shared::Ray& ray, const shared::CameraPath& path);
void compareClosestHit(const Stage& stage, std::size_t i, const shared::Ray& ray, const shared::Hit& hit);

using TwinFunction = void (*)(const Stage&);

// nullptr: there is none.
[[nodiscard]] TwinFunction twinOf(std::string_view kernel);

// By file of host/parity/.
void compareGenerateCameraRays(const Stage& stage); // twins_camera.cpp
void compareBouncePaths(const Stage& stage);
void compareStartGatherRays(const Stage& stage);
void compareShadeSurface(const Stage& stage); // twins_shading.cpp
void compareTraceWhitted(const Stage& stage);
void compareTraceClosest(const Stage& stage); // twins_rays.cpp
void compareTraceShadow(const Stage& stage);
void compareSampleLights(const Stage& stage); // twins_lights.cpp
void compareSampleRoughLights(const Stage& stage);
void compareEmitPhotons(const Stage& stage); // twins_photons.cpp
void compareEmitCausticPhotons(const Stage& stage);
void compareScatterPhoton(const Stage& stage);
void compareCastShadowPhotons(const Stage& stage);
void compareSumChunks(const Stage& stage); // twins_queues.cpp
void compareScanGroup(const Stage& stage);
void compareScanChunks(const Stage& stage);
void compareListNextRays(const Stage& stage);
void compareCompactCameraPaths(const Stage& stage);
void compareCompactPhotonPaths(const Stage& stage);
void compareCountCells(const Stage& stage); // twins_grid.cpp
void compareFillCells(const Stage& stage);
void compareOrderCells(const Stage& stage);
void compareSortPhotons(const Stage& stage);
void compareMarkPhotons(const Stage& stage); // twins_tree.cpp
void compareKeyPhotons(const Stage& stage);
void compareCountDigits(const Stage& stage);
void compareSortDigits(const Stage& stage);
void compareSplitNodes(const Stage& stage);
void compareCountSides(const Stage& stage);
void comparePartSides(const Stage& stage);
void compareFinishSubtrees(const Stage& stage);
void comparePlacePhotons(const Stage& stage);
void compareGatherRadiance(const Stage& stage); // twins_estimates.cpp
void compareEstimateRadiance(const Stage& stage);
void compareBeginIrradiance(const Stage& stage);
void compareStoreIrradiance(const Stage& stage);
void compareLookUpIrradiance(const Stage& stage);
void compareClassifyVisibility(const Stage& stage);
void compareSkipShadowRays(const Stage& stage);
void compareSplatPhotons(const Stage& stage); // twins_film.cpp
void compareShowSurface(const Stage& stage);
void compareSumPaths(const Stage& stage);
void compareAddGatheredLight(const Stage& stage);
void compareAccumulateFilm(const Stage& stage);
void compareResolveFilm(const Stage& stage);
void compareEstimateError(const Stage& stage);

} // namespace hyalite::parity
