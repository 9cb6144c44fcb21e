#include "render/photons/photon_query.h"

#include "base/error.h"

#include "shaders/shared/limits.h"
#include "shaders/shared/photon_map.h"

#include <algorithm>
#include <bit>
#include <string>

namespace hyalite::render {

namespace {

void checkNearest(std::uint32_t nearest, std::uint32_t least, std::uint32_t most) {
    if (nearest < least || nearest > most) {
        throw Error(ExitCode::BadInput, "cannot run a search for " + std::to_string(nearest) + " photons",
                    "a search finds " + std::to_string(least) + " to " + std::to_string(most));
    }
}

// Rounds to few sizes, so that few kernels are compiled.
std::uint32_t heapCapacity(std::uint32_t nearest, std::uint32_t least) {
    checkNearest(nearest, least, shared::kMaxNearest);
    constexpr std::uint32_t kLeast = 8;
    return std::max(kLeast, std::bit_ceil(nearest));
}

gpu::Specialization specialized(PhotonStructure structure, std::uint32_t capacity, gpu::Specialization constants = {}) {
    constants["kNearestCapacity"] = capacity;
    constants["kPhotonStructure"] = structure == PhotonStructure::Tree ? shared::kPhotonTree : shared::kPhotonGrid;
    return constants;
}

std::uint32_t filterNumber(PhotonFilter filter) {
    switch (filter) {
    case PhotonFilter::Cone:
        return shared::kFilterCone;
    case PhotonFilter::Gaussian:
        return shared::kFilterGaussian;
    case PhotonFilter::Custom:
        return shared::kFilterCustom;
    case PhotonFilter::None:
        break;
    }
    return shared::kFilterNone;
}

} // namespace

gpu::Specialization searchOf(PhotonStructure structure, std::uint32_t nearest, const gpu::Specialization& constants) {
    return specialized(structure, heapCapacity(nearest, 1), constants);
}

NearestPhotons::NearestPhotons(const Device& device, PhotonStructure structure, std::uint32_t nearest)
    : capacity_(heapCapacity(nearest, 1)),
      nearestPhotons_(device.kernel("nearest_photons", specialized(structure, capacity_))) {}

void NearestPhotons::run(Device& device, const shared::PhotonMapRecord& map, shared::VisiblePointArray points,
                         std::uint32_t count, const PhotonSearch& search, shared::UintArray found) {
    checkNearest(search.nearest, 1, capacity_);
    device.commands.run(nearestPhotons_,
                        shared::NearestPhotonsArguments{.visiblePoints = points,
                                                        .map = map,
                                                        .found = found,
                                                        .radius = search.radius,
                                                        .nearest = search.nearest,
                                                        .kinds = search.kinds,
                                                        .count = count,
                                                        .maxDepth = search.maxDepth,
                                                        .surfaceError = search.surfaceError},
                        count);
}

RadianceEstimate::RadianceEstimate(const Device& device, const DeviceScene& deviceScene, PhotonStructure structure,
                                   std::uint32_t nearest)
    : deviceScene_(deviceScene), capacity_(heapCapacity(nearest, 2)),
      estimateRadiance_(
          device.kernel("estimate_radiance", specialized(structure, capacity_, deviceScene.specialization))) {}

void RadianceEstimate::run(Device& device, const shared::PhotonMapRecord& map, shared::VisiblePointArray points,
                           std::uint32_t count, const PhotonSearch& search, const PhotonDensity& density,
                           shared::ColorArray gathered, shared::FloatArray radii) {
    checkNearest(search.nearest, 2, capacity_);
    device.commands.run(estimateRadiance_,
                        shared::EstimateRadianceArguments{.visiblePoints = points,
                                                          .materials = deviceScene_.materials,
                                                          .map = map,
                                                          .gathered = gathered,
                                                          .radii = radii,
                                                          .radius = search.radius,
                                                          .filterConstant = density.coneConstant,
                                                          .maxChange = density.maxChange,
                                                          .nearest = search.nearest,
                                                          .kinds = search.kinds,
                                                          .filterKind = filterNumber(density.filter),
                                                          .count = count,
                                                          .maxDepth = search.maxDepth,
                                                          .width = search.width,
                                                          .surfaceError = search.surfaceError,
                                                          .eye = density.eye,
                                                          .footprint = density.footprint},
                        count);
}

} // namespace hyalite::render
