#include "render/photons/photon_maps.h"

#include "geometry/search_radius.h"
#include "render/photons/photon_slots.h"
#include "scene/model/bounds.h"
#include "scene/model/render_seed.h"

#include <algorithm>
#include <utility>

namespace hyalite::render {

namespace {

constexpr std::uint32_t kAllLight =
    1U << shared::kPhotonDirect | 1U << shared::kPhotonIndirect | 1U << shared::kPhotonCaustic;

// Relative change of the density at which an estimate from the caustic map stops growing.
constexpr float kEdgeChange = 0.5F;

gpu::Array<shared::Photon> upload(const Device& device, const std::vector<shared::Photon>& photons) {
    return {device.context, std::span<const shared::Photon>(photons), "photons"};
}

std::uint32_t countOf(const std::vector<shared::Photon>& photons) {
    return static_cast<std::uint32_t>(photons.size());
}

} // namespace

PhotonMaps::PhotonMaps(Device& device, const Scene& scene, const DeviceScene& deviceScene)
    : device_(device), scene_(scene), deviceScene_(deviceScene), settings_(scene.render.photonMap),
      globalRadius_(static_cast<float>(globalSearchRadius(scene))),
      causticRadius_(static_cast<float>(causticSearchRadius(scene))), shadowRadius_(causticRadius_),
      surfaceError_(static_cast<float>(surfaceError(scene))), global_(device, settings_.structure),
      caustic_(device, settings_.structure), shadow_(device, settings_.structure),
      irradiance_(device, settings_.structure),
      estimateGlobal_(device, deviceScene, settings_.structure, settings_.nearest),
      estimateCaustics_(device, deviceScene, settings_.structure, settings_.causticNearest),
      lookUpIrradiance_(
          device.kernel("look_up_irradiance", searchOf(settings_.structure, 1, deviceScene.specialization))),
      classifyVisibility_(device.kernel("classify_visibility", searchOf(settings_.structure, classifiedNearest()))) {}

void PhotonMaps::trace() {
    lists_.global = traceGlobal();
    lists_.caustic = traceCaustics();
    lists_.shadow = castShadows();
}

std::vector<shared::Photon> PhotonMaps::traceGlobal() {
    PhotonPaths paths(device_, scene_, deviceScene_, std::min(kPhotonsInFlight, scene_.render.photons));
    const gpu::FinishAtEnd finish(device_.commands);
    const std::uint32_t slots =
        paths.trace({.sequence = shared::photonSequence(renderSeed(scene_.render), shared::kGlobalPhotons, 0),
                     .count = scene_.render.photons,
                     .kinds = kAllLight,
                     .account = true});
    device_.commands.finish();
    balance_ = paths.balance();
    raysTraced_ += paths.raysTraced();
    return storedPhotons(paths.photons(), slots);
}

std::vector<shared::Photon> PhotonMaps::traceCaustics() {
    if (settings_.causticPhotons == 0 || !hasTargets()) {
        return {};
    }
    PhotonPaths paths(device_, scene_, deviceScene_, std::min(kPhotonsInFlight, settings_.causticPhotons));
    const gpu::FinishAtEnd finish(device_.commands);
    const std::uint32_t slots =
        paths.trace({.sequence = shared::photonSequence(renderSeed(scene_.render), shared::kCausticPhotons, 0),
                     .count = settings_.causticPhotons,
                     .kinds = 1U << shared::kPhotonCaustic,
                     .aimed = settings_.projectionMap});
    device_.commands.finish();
    raysTraced_ += paths.raysTraced();
    return storedPhotons(paths.photons(), slots);
}

std::vector<shared::Photon> PhotonMaps::castShadows() {
    if (settings_.shadowPhotons == 0) {
        return {};
    }
    ShadowPhotonPaths paths(device_, scene_, deviceScene_, std::min(kPhotonsInFlight, scene_.render.photons));
    const gpu::FinishAtEnd finish(device_.commands);
    const std::uint32_t slots = paths.cast(scene_.render.photons);
    device_.commands.finish();
    raysTraced_ += paths.raysTraced();
    return storedPhotons(paths.photons(), slots);
}

void PhotonMaps::limitRadii() {
    const auto limit = [this](float& radius, std::size_t nearest, const std::vector<shared::Photon>& photons,
                              double footprint) {
        std::vector<glm::dvec3> positions;
        for (const shared::Photon& photon : photons) {
            positions.emplace_back(photon.position);
        }
        radius = static_cast<float>(largestEstimateFor(nearest, positions, double{radius},
                                                       {.eye = scene_.camera.position, .footprint = footprint}));
    };
    if (scene_.render.radius == 0) {
        limit(globalRadius_, settings_.nearest, lists_.global, 0);
    }
    if (settings_.causticRadius == 0) {
        limit(causticRadius_, settings_.causticNearest, lists_.caustic, pixelFootprint(scene_.camera));
    }
}

void PhotonMaps::build() {
    limitRadii();
    const bool records = settings_.gatherRays > 0 && settings_.precomputedIrradiance;
    // There are at most as many irradiance records as photons in the global map
    table_ = {device_.context, lists_.global.size() * (records ? 2 : 1) + lists_.caustic.size() + lists_.shadow.size(),
              "photon table"};
    device_.tables.set(TABLE_PHOTONS, table_.buffer(), gpu::TexelFormat::Float4);
    std::uint32_t base = sortInto(caustic_, upload(device_, lists_.caustic), 0, causticRadius_);
    base = sortInto(shadow_, upload(device_, lists_.shadow), base, shadowRadius_);
    const gpu::Array<shared::Photon> photons = upload(device_, lists_.global);
    base = sortInto(global_, photons, base, globalRadius_);
    if (records) {
        static_cast<void>(sortInto(irradiance_, computeIrradiance(photons), base, globalRadius_));
    }
}

std::uint32_t PhotonMaps::sortInto(SearchableMap& map, const gpu::Array<shared::Photon>& photons, std::uint32_t base,
                                   float radius) {
    map.build(device_, photons, static_cast<std::uint32_t>(photons.count()), table_, base, radius);
    device_.commands.finish();
    return base + map.record().count;
}

gpu::Array<shared::Photon> PhotonMaps::computeIrradiance(const gpu::Array<shared::Photon>& photons) {
    const auto count = static_cast<std::uint32_t>(photons.count());
    const gpu::Array<shared::VisiblePoint> points(device_.context, count, "places of photons");
    const gpu::Array<glm::vec3> irradiance(device_.context, count, "irradiance");
    const gpu::Array<float> radii(device_.context, count, "radii of estimates");
    gpu::Array<shared::Photon> records(device_.context, count, "records of irradiance");
    const gpu::FinishAtEnd finish(device_.commands);
    const gpu::Kernel beginIrradiance = device_.kernel("begin_irradiance");
    const gpu::Kernel storeIrradiance = device_.kernel("store_irradiance");
    device_.commands.run(beginIrradiance,
                         shared::BeginIrradianceArguments{.photons = photons, .visiblePoints = points, .count = count},
                         count);
    estimateGlobal(points, kAllLight, irradiance, radii);
    device_.commands.run(
        storeIrradiance,
        shared::StoreIrradianceArguments{
            .photons = photons, .irradiance = irradiance, .radii = radii, .records = records, .count = count},
        count);
    device_.commands.finish();
    return records;
}

void PhotonMaps::estimateGlobal(const gpu::Array<shared::VisiblePoint>& x, std::uint32_t kinds,
                                const gpu::Array<glm::vec3>& gathered, const gpu::Array<float>& radii) {
    const auto count = static_cast<std::uint32_t>(x.count());
    estimateGlobal_.run(device_, global_.record(), x, count,
                        {.nearest = settings_.nearest,
                         .radius = globalRadius_,
                         .kinds = kinds,
                         .maxDepth = scene_.render.maxDepth,
                         .width = deviceScene_.widthOf(count),
                         .surfaceError = surfaceError_},
                        density(settings_.filter), gathered, radii);
}

PhotonDensity PhotonMaps::density(PhotonFilter filter) const {
    return {.filter = filter,
            .coneConstant = static_cast<float>(settings_.coneConstant),
            .maxChange = 0,
            .eye = deviceScene_.camera.position,
            .footprint = 0}; // diffuse surfaces do not focus
}

void PhotonMaps::estimateCaustics(const gpu::Array<shared::VisiblePoint>& x, const gpu::Array<glm::vec3>& gathered,
                                  const gpu::Array<float>& radii) {
    const auto count = static_cast<std::uint32_t>(x.count());
    PhotonDensity caustics = density(settings_.causticFilter);
    caustics.footprint = static_cast<float>(pixelFootprint(scene_.camera));
    caustics.maxChange = settings_.differentialChecking ? kEdgeChange : 0;
    estimateCaustics_.run(device_, caustic_.record(), x, count,
                          {.nearest = settings_.causticNearest,
                           .radius = causticRadius_,
                           .kinds = 1U << shared::kPhotonCaustic,
                           .maxDepth = scene_.render.maxDepth,
                           .width = deviceScene_.widthOf(count),
                           .surfaceError = surfaceError_},
                          caustics, gathered, radii);
}

void PhotonMaps::addIrradiance(const gpu::Array<shared::VisiblePoint>& y, const gpu::Array<glm::vec3>& gathered,
                               float scale) {
    const auto count = static_cast<std::uint32_t>(y.count());
    device_.commands.run(lookUpIrradiance_,
                         shared::LookUpIrradianceArguments{.visiblePoints = y,
                                                           .materials = deviceScene_.materials,
                                                           .gathered = gathered,
                                                           .map = irradiance_.record(),
                                                           .radius = globalRadius_,
                                                           .scale = scale,
                                                           .count = count,
                                                           .surfaceError = surfaceError_},
                         count);
}

std::uint32_t PhotonMaps::classifiedNearest() const {
    const std::uint32_t lights = std::min(deviceScene_.lightCount, shared::kMostClassifiedLights);
    return std::clamp(settings_.shadowPhotons * lights, 1U, shared::kMaxNearest);
}

void PhotonMaps::classify(const gpu::Array<shared::VisiblePoint>& x, const gpu::Array<shared::uint>& lit,
                          const gpu::Array<shared::uint>& shadowed) {
    const auto count = static_cast<std::uint32_t>(x.count());
    device_.commands.run(classifyVisibility_,
                         shared::ClassifyVisibilityArguments{.visiblePoints = x,
                                                             .lit = lit,
                                                             .shadowed = shadowed,
                                                             .map = shadow_.record(),
                                                             .lightCount = deviceScene_.lightCount,
                                                             .nearest = classifiedNearest(),
                                                             .agreeing = settings_.shadowPhotons,
                                                             .radius = shadowRadius_,
                                                             .count = count,
                                                             .surfaceError = surfaceError_},
                         count);
}

void PhotonMaps::splat(const gpu::Array<shared::uint>& counts) {
    const gpu::Kernel kernel = device_.kernel("splat_photons", deviceScene_.specialization);
    for (const auto* list : {&lists_.global, &lists_.caustic, &lists_.shadow}) {
        const gpu::Array<shared::Photon> photons = upload(device_, *list);
        device_.commands.run(kernel,
                             shared::SplatPhotonsArguments{.photons = photons,
                                                           .counts = counts,
                                                           .camera = deviceScene_.camera,
                                                           .count = countOf(*list),
                                                           .rootNode = deviceScene_.rootNode},
                             countOf(*list));
        device_.commands.finish();
    }
}

} // namespace hyalite::render
