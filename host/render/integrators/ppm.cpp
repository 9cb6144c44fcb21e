#include "render/integrators/ppm.h"

#include "geometry/search_radius.h"
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
    // r^2_{i+1} = r^2_i (i + alpha) / (i + 1), passes counted from 1 there and from 0 here
    double radius2 = initial * initial;
    for (std::uint32_t i = 1; i <= pass; ++i) {
        radius2 *= (i + alpha) / (i + 1.0);
    }
    return std::sqrt(radius2);
}

Ppm::Ppm(Device& device, const Scene& scene, const DeviceScene& deviceScene, const Film& film)
    : device_(device), scene_(scene), deviceScene_(deviceScene), film_(film),
      cameraPaths_(device, scene, deviceScene, film.pixelCount()),
      lightSampler_(device, deviceScene, film.pixelCount()),
      photonPaths_(device, scene, deviceScene,
                   std::min(kPhotonsInFlight, std::max(scene.render.photons, scene.render.photonMap.causticPhotons))),
      grid_(device), gatherRadiance_(device.kernel("gather_radiance", deviceScene.specialization)),
      photons_(photonsOf(scene, deviceScene)), visiblePoints_(device.context, film.pixelCount(), "visible points"),
      emitted_(device.context, film.pixelCount(), "emitted light"),
      direct_(device.context, film.pixelCount(), "direct light"),
      gathered_(device.context, film.pixelCount(), "gathered light") {}

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
    for (Photons& kind : photons) {
        kind.radius = kind.radius > 0 ? kind.radius : radiusByPilot(kind);
        (kind.layer == kCaustic ? notes_.causticSearchRadius : notes_.searchRadius) = kind.radius;
    }
    return photons;
}

PhotonPass Ppm::photonPass(const Photons& photons, std::uint32_t pass) const {
    return {.sequence = shared::photonSequence(renderSeed(scene_.render), photons.purpose, pass),
            .count = photons.count,
            .kinds = photons.kinds,
            .aimed = photons.aimed};
}

double Ppm::radiusByPilot(const Photons& photons) {
    PhotonPass pilot = photonPass(photons, 0);
    pilot.count = std::min(pilot.count, kPilotPhotons);
    const std::uint32_t slots = photonPaths_.trace(pilot);
    device_.commands.finish();
    std::vector<glm::dvec3> positions;
    for (const shared::Photon& photon : storedPhotons(photonPaths_.photons(), slots)) {
        positions.emplace_back(photon.position);
    }
    const double wanted = photons.layer == kCaustic ? kCausticPhotonsPerSearch : kPhotonsPerSearch;
    return searchRadiusFor(wanted, positions, pilot.count, photons.count, sceneRadius(scene_));
}

void Ppm::renderPass(std::uint32_t pass) {
    // Where each pixel's path first meets a diffuse surface, through mirrors and glass, and the emission on the way; at
    // rough metal and glass also the light that comes there straight from a lamp
    device_.commands.clear(direct_.buffer());
    cameraPaths_.generate(pass);
    const RaysTraced rays = cameraPaths_.follow(pass, visiblePoints_, emitted_, &direct_);
    counts_.cameraRays += rays.camera;
    counts_.shadowRays += rays.shadow;
    // Light that comes to the diffuse surface straight from a lamp
    sampleDirectLight(pass);
    film_.add(device_, kEmitted, emitted_);
    film_.add(device_, kDirect, direct_);
    // Light that comes by way of other surfaces, as flux landing all over the scene, whose density about each visible
    // point is the rest of its light: by way of diffuse ones, and of mirrors and glass alone
    for (const Photons& photons : photons_) {
        gather(photons, pass);
        film_.add(device_, photons.layer, gathered_);
    }
    device_.commands.finish();
}

void Ppm::sampleDirectLight(std::uint32_t pass) {
    lightSampler_.sample(visiblePoints_, shared::kNone, pass, scene_.render.maxDepth);
    lightSampler_.trace(direct_);
    counts_.shadowRays += film_.pixelCount();
}

void Ppm::gather(const Photons& photons, std::uint32_t pass) {
    const std::uint64_t raysBefore = photonPaths_.raysTraced();
    const std::uint32_t slots = photonPaths_.trace(photonPass(photons, pass));
    const auto radius = static_cast<float>(searchRadius(photons.radius, scene_.render.alpha, pass));
    grid_.build(device_, photonPaths_.photons(), slots, radius);
    const std::uint32_t pixels = film_.pixelCount();
    device_.commands.run(gatherRadiance_,
                         shared::GatherRadianceArguments{visiblePoints_, deviceScene_.materials, grid_.cellStarts(),
                                                         gathered_, grid_.record(), radius, pixels,
                                                         scene_.render.maxDepth, film_.resolution().x},
                         pixels);
    counts_.photonRays += photonPaths_.raysTraced() - raysBefore;
    (photons.layer == kCaustic ? counts_.causticPhotonsEmitted : counts_.photonsEmitted) += photons.count;
    (photons.layer == kCaustic ? counts_.causticPhotonsStored : counts_.photonsStored) += grid_.photonCount();
}

} // namespace hyalite::render
