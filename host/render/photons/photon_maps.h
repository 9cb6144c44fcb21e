// The photon maps of photon mapping: traced from the lights, sorted into one table on the device, and searched at
// visible points.
#pragma once

#include "render/photons/photon_file.h"
#include "render/photons/photon_paths.h"
#include "render/photons/photon_query.h"
#include "render/photons/searchable_map.h"
#include "render/photons/shadow_photons.h"

#include <vector>

namespace hyalite::render {

class PhotonMaps {
public:
    // Keeps the references.
    PhotonMaps(Device& device, const Scene& scene, const DeviceScene& deviceScene);

    // Traces the photons of all maps that the settings request …
    void trace();
    // … or takes them from lists of the same scene and settings.
    void load(PhotonLists lists) { lists_ = std::move(lists); }
    [[nodiscard]] const PhotonLists& lists() const { return lists_; }

    // Sorts the photons into maps and computes the irradiance records. Call after trace() or load().
    void build();

    // Radiance [W/(m^2 sr)] at each visible point, from the photons of `kinds` in the global map, or from the caustic
    // map. `radii`: of the estimates [m].
    void estimateGlobal(const gpu::Array<shared::VisiblePoint>& x, std::uint32_t kinds,
                        const gpu::Array<glm::vec3>& gathered, const gpu::Array<float>& radii);
    void estimateCaustics(const gpu::Array<shared::VisiblePoint>& x, const gpu::Array<glm::vec3>& gathered,
                          const gpu::Array<float>& radii);
    // Adds the radiance from irradiance records at the visible points, times `scale`. Points that have found a record
    // get depth 0; the others are for estimateGlobal.
    void addIrradiance(const gpu::Array<shared::VisiblePoint>& y, const gpu::Array<glm::vec3>& gathered, float scale);
    // Decides which lights are visible from the visible points; only if the settings request shadow photons.
    void classify(const gpu::Array<shared::VisiblePoint>& x, const gpu::Array<shared::uint>& lit,
                  const gpu::Array<shared::uint>& shadowed);

    // Counts the photons visible to the camera, per pixel and kind.
    void splat(const gpu::Array<shared::uint>& counts);

    [[nodiscard]] bool hasTargets() const { return deviceScene_.targetCount > 0; }
    [[nodiscard]] const std::vector<LightBalance>& balance() const { return balance_; }
    [[nodiscard]] std::uint64_t raysTraced() const { return raysTraced_; }

private:
    [[nodiscard]] std::vector<shared::Photon> traceGlobal();
    [[nodiscard]] std::vector<shared::Photon> traceCaustics();
    [[nodiscard]] std::vector<shared::Photon> castShadows();
    void limitRadii(); // by the density of the photons, where the settings leave them open
    [[nodiscard]] std::uint32_t sortInto(SearchableMap& map, const gpu::Array<shared::Photon>& photons,
                                         std::uint32_t base, float radius);
    [[nodiscard]] gpu::Array<shared::Photon> computeIrradiance(const gpu::Array<shared::Photon>& photons);
    [[nodiscard]] std::uint32_t classifiedNearest() const;
    [[nodiscard]] PhotonDensity density(PhotonFilter filter) const;

    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    const PhotonMapSettings& settings_;
    float globalRadius_;  // largest of an estimate from the global map [m]
    float causticRadius_; // likewise, from the caustic map
    float shadowRadius_;
    float surfaceError_;
    PhotonLists lists_;
    std::vector<LightBalance> balance_;
    std::uint64_t raysTraced_ = 0;

    gpu::Array<shared::Photon> table_; // of all maps: TABLE_PHOTONS
    SearchableMap global_;
    SearchableMap caustic_;
    SearchableMap shadow_;
    SearchableMap irradiance_;
    RadianceEstimate estimateGlobal_;
    RadianceEstimate estimateCaustics_;
    gpu::Kernel lookUpIrradiance_;
    gpu::Kernel classifyVisibility_;
};

} // namespace hyalite::render
