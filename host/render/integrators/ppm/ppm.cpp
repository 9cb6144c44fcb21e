#include "render/integrators/ppm/ppm.h"

#include "geometry/search_radius.h"
#include "reference/integrators/ppm.h"
#include "render/photons/photon_slots.h"
#include "scene/model/bounds.h"
#include "scene/model/render_seed.h"

#include <algorithm>
#include <cmath>

namespace hyalite::render {

namespace {

enum Layer : std::uint32_t { kEmitted, kDirect, kCaustic, kIndirect };

} // namespace

double searchRadius(double initial, double alpha, std::uint32_t pass) {
    // r^2_{i+1} = r^2_i (i + alpha) / (i + 1), where the paper counts passes from 1 and the code from 0
    double radius2 = initial * initial;
    for (std::uint32_t i = 1; i <= pass; ++i) {
        radius2 *= (i + alpha) / (i + 1.0);
    }
    return std::sqrt(radius2);
}

IntegratorKind Ppm::kind() {
    return {.name = "ppm",
            .layers = [](const RenderSettings&) -> std::vector<LayerKind> {
                return {{"emitted"}, {"direct"}, {"caustic"}, {"indirect"}};
            },
            .make = makeIntegrator<Ppm>,
            .reference = reference::renderPpm,
            .simplifyForPaths = [](RenderSettings& render) { // no search radius has to be found
                render.radius = 1;
                render.photonMap.causticRadius = 1;
            }};
}

Ppm::Ppm(const IntegratorInput& input)
    : device_(input.device), scene_(input.scene), deviceScene_(input.deviceScene), film_(input.film),
      cameraPaths_(device_, scene_, input.deviceScene, film_.pixelCount(), film_.sought()),
      lightSampler_(device_, input.deviceScene, film_.pixelCount(), film_.sought()),
      photonPaths_(device_, scene_, input.deviceScene,
                   std::min(kPhotonsInFlight, std::max(scene_.render.photons, scene_.render.photonMap.causticPhotons))),
      grid_(device_), gatherRadiance_(device_.kernel("gather_radiance", deviceScene_.specialization)),
      photons_(photonsOf(scene_, input.deviceScene)),
      visiblePoints_(device_.context, film_.pixelCount(), "visible points"),
      emitted_(device_.context, film_.pixelCount(), "emitted light"),
      direct_(device_.context, film_.pixelCount(), "direct light"),
      gathered_(device_.context, film_.pixelCount(), "gathered light") {}

std::vector<Ppm::Photons> Ppm::photonsOf(const Scene& scene, const DeviceScene& deviceScene) {
    const PhotonMapSettings& settings = scene.render.photonMap;
    constexpr std::uint32_t kIndirectOnly = 1U << shared::kPhotonIndirect;
    constexpr std::uint32_t kCausticOnly = 1U << shared::kPhotonCaustic;
    const bool ownCaustics = settings.causticPhotons > 0 && deviceScene.targetCount > 0;
    std::vector<Photons> photons;
    photons.push_back({.purpose = shared::kGlobalPhotons,
                       .count = scene.render.photons,
                       .kinds = ownCaustics ? kIndirectOnly : kIndirectOnly | kCausticOnly,
                       .aimed = false,
                       .layer = kIndirect,
                       .radius = scene.render.radius});
    if (ownCaustics) {
        photons.push_back({.purpose = shared::kCausticPhotons,
                           .count = settings.causticPhotons,
                           .kinds = kCausticOnly,
                           .aimed = settings.projectionMap,
                           .layer = kCaustic,
                           .radius = settings.causticRadius});
    }
    return photons;
}

void Ppm::prepare() {
    for (Photons& photons : photons_) {
        photons.radius = photons.radius > 0 ? photons.radius : radiusByPilot(photons);
        (photons.layer == kCaustic ? notes_.causticSearchRadius : notes_.searchRadius) = photons.radius;
    }
}

PhotonPass Ppm::photonPass(const Photons& photons, std::uint32_t pass) const {
    return {.sequence = shared::photonSequence(renderSeed(scene_.render), photons.purpose, pass),
            .count = photons.count,
            .kinds = photons.kinds,
            .aimed = photons.aimed};
}

std::vector<glm::dvec3> Ppm::tracePilot(const PhotonPass& pilot) {
    const std::uint32_t slots = photonPaths_.trace(pilot);
    device_.commands.finish();
    std::vector<glm::dvec3> positions;
    for (const shared::Photon& photon : storedPhotons(photonPaths_.photons(), slots)) {
        positions.emplace_back(photon.position);
    }
    return positions;
}

double Ppm::radiusByPilot(const Photons& photons) {
    PhotonPass pilot = photonPass(photons, 0);
    pilot.count = std::min(pilot.count, kPilotPhotons);
    std::vector<glm::dvec3> positions = tracePilot(pilot);
    if (positions.size() < kFewPhotons && pilot.count < photons.count) {
        pilot.count = photons.count;
        positions = tracePilot(pilot);
    }
    const double wanted = photons.layer == kCaustic ? kCausticPhotonsPerSearch : kPhotonsPerSearch;
    return searchRadiusFor(wanted, positions, pilot.count, photons.count,
                           {.sceneRadius = sceneRadius(scene_),
                            .eye = scene_.camera.position,
                            .footprint = photons.layer == kCaustic ? pixelFootprint(scene_.camera) : 0});
}

void Ppm::renderPass(std::uint32_t pass) {
    // Each pixel's first diffuse surface, through mirrors and glass, and the emission on the way; at rough metal and
    // glass also the direct light
    device_.commands.clear(direct_.buffer());
    cameraPaths_.generate(pass);
    cameraPaths_.follow(pass, visiblePoints_, emitted_, &direct_);
    // Direct light on the diffuse surface
    sampleDirectLight(pass);
    film_.add(device_, kEmitted, emitted_);
    film_.add(device_, kDirect, direct_);
    // Light that comes by other surfaces: photons deposit flux all over the scene, and its density around each visible
    // point is the rest of the point's light, from diffuse surfaces and from mirrors and glass alone
    for (const Photons& photons : photons_) {
        gather(photons, pass);
        film_.add(device_, photons.layer, gathered_);
    }
    device_.commands.finish();
    const RaysTraced rays = cameraPaths_.raysTraced();
    counts_[Counter::CameraRays] = rays.camera;
    counts_[Counter::ShadowRays] = rays.shadow + lightSampler_.raysTraced();
}

void Ppm::sampleDirectLight(std::uint32_t pass) {
    lightSampler_.sample(visiblePoints_, shared::kNone, pass, scene_.render.maxDepth);
    lightSampler_.trace(direct_);
}

void Ppm::gather(const Photons& photons, std::uint32_t pass) {
    const std::uint64_t raysBefore = photonPaths_.raysTraced();
    const std::uint32_t slots = photonPaths_.trace(photonPass(photons, pass));
    const auto radius = static_cast<float>(searchRadius(photons.radius, scene_.render.alpha, pass));
    grid_.build(device_, photonPaths_.photons(), slots, radius);
    const std::uint32_t pixels = film_.pixelCount();
    device_.commands.run(gatherRadiance_,
                         shared::GatherRadianceArguments{.visiblePoints = visiblePoints_,
                                                         .materials = deviceScene_.materials,
                                                         .cellStarts = grid_.cellStarts(),
                                                         .gathered = gathered_,
                                                         .grid = grid_.record(),
                                                         .radius = radius,
                                                         .count = pixels,
                                                         .maxDepth = scene_.render.maxDepth,
                                                         .width = film_.resolution().x,
                                                         .surfaceError = static_cast<float>(surfaceError(scene_))},
                         pixels);
    counts_[Counter::PhotonRays] += photonPaths_.raysTraced() - raysBefore;
    const bool caustic = photons.layer == kCaustic;
    counts_[caustic ? Counter::CausticPhotonsEmitted : Counter::PhotonsEmitted] += photons.count;
    counts_[caustic ? Counter::CausticPhotonsStored : Counter::PhotonsStored] += grid_.photonCount();
}

} // namespace hyalite::render
