// Photon map searches at every visible point: the radiance estimate from the nearest photons, and the photons
// themselves.
#pragma once

#include "render/upload/device_scene.h"
#include "render/wavefront/device.h"
#include "scene/model/scene.h"

#include "shaders/shared/kernel_arguments.h"

namespace hyalite::render {

using hyalite::PhotonFilter;
using hyalite::PhotonStructure;

// Specialization of a kernel that searches photon maps: the structure, and room for `nearest` photons.
[[nodiscard]] gpu::Specialization searchOf(PhotonStructure structure, std::uint32_t nearest,
                                           const gpu::Specialization& constants = {});

// The photons that a search takes.
struct PhotonSearch {
    std::uint32_t nearest = 50; // number of photons, 1 … shared::kMaxNearest
    float radius = 0;           // largest distance [m]; for a grid, at most the radius that it was built for
    std::uint32_t kinds = 0;    // bit shared::kPhoton… is set for every kind that counts
    std::uint32_t maxDepth = 0; // segments of the photon's path and the camera's together
    std::uint32_t width = 0;    // of the picture, if the points are its pixels
    float surfaceError = 0;     // of positions on surfaces [m]
};

struct PhotonDensity {
    PhotonFilter filter = PhotonFilter::None;
    float coneConstant = 1.1F; // the cone's radius over the disc's, >= 1
    float maxChange = 0;       // relative change of the density at which discs stop growing; 0: they do not stop
    glm::vec3 eye{0};          // centre of the lens [m]
    float footprint = 0;       // least radius of a disc over its distance from there
};

// Finds up to `nearest` photons for each point.
class NearestPhotons {
public:
    NearestPhotons(const Device& device, PhotonStructure structure, std::uint32_t nearest);

    // Records the search of `map` at `count` points. `found`: search.nearest slots for each, the nearest first, then
    // kNone. search.nearest must not exceed the number given at construction.
    void run(Device& device, const shared::PhotonMapRecord& map, shared::VisiblePointArray points, std::uint32_t count,
             const PhotonSearch& search, shared::UintArray found);

private:
    std::uint32_t capacity_;
    gpu::Kernel nearestPhotons_;
};

// Estimates reflected radiance from the nearest photons.
class RadianceEstimate {
public:
    // Keeps a reference to the scene. `nearest`: at least 2, because the farthest photon only bounds the disc. Throws
    // Error(BadInput) otherwise.
    RadianceEstimate(const Device& device, const DeviceScene& deviceScene, PhotonStructure structure,
                     std::uint32_t nearest);

    // Records the estimate at `count` points: radiance [W/(m^2 sr)] and the radius of its disc [m].
    void run(Device& device, const shared::PhotonMapRecord& map, shared::VisiblePointArray points, std::uint32_t count,
             const PhotonSearch& search, const PhotonDensity& density, shared::ColorArray gathered,
             shared::FloatArray radii);

private:
    const DeviceScene& deviceScene_;
    std::uint32_t capacity_;
    gpu::Kernel estimateRadiance_;
};

} // namespace hyalite::render
