#include "render/ppm.h"

#include "scene/bounds.h"
#include "scene/render_seed.h"

#include <cmath>

namespace hyalite::render {

double searchRadius(double initial, double alpha, std::uint32_t pass) {
    // r^2_{i+1} = r^2_i (i + alpha) / (i + 1), passes counted from 1 there and from 0 here
    double radius2 = initial * initial;
    for (std::uint32_t i = 1; i <= pass; ++i) {
        radius2 *= (i + alpha) / (i + 1.0);
    }
    return std::sqrt(radius2);
}

Ppm::Ppm(Device& device, const Scene& scene, const DeviceScene& deviceScene, const Film& film)
    : device_(device), scene_(scene), film_(film), initialRadius_(initialRadius(scene)),
      cameraPaths_(device, scene, deviceScene, film.pixelCount()),
      lightSampler_(device, deviceScene, film.pixelCount()),
      photonPaths_(device, scene, deviceScene, scene.render.photons), grid_(device),
      gatherRadiance_(device.kernel("gather_radiance")),
      visiblePoints_(device.context, film.pixelCount(), "visible points"),
      emitted_(device.context, film.pixelCount(), "emitted light"),
      direct_(device.context, film.pixelCount(), "direct light"),
      gathered_(device.context, film.pixelCount(), "gathered light") {}

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
    // Light that comes by way of other surfaces, as flux landing all over the scene …
    const std::uint32_t slots =
        photonPaths_.trace({.sequence = shared::photonSequence(renderSeed(scene_.render), shared::kGlobalPhotons, pass),
                            .count = scene_.render.photons,
                            .kinds = 1U << shared::kPhotonIndirect | 1U << shared::kPhotonCaustic});
    counts_.photonsEmitted += scene_.render.photons;
    counts_.photonRays = photonPaths_.raysTraced();
    // … whose density about each visible point is the rest of its light
    gatherPhotons(pass, slots);
    film_.add(device_, 0, emitted_);
    film_.add(device_, 1, direct_);
    film_.add(device_, 2, gathered_);
    device_.commands.finish();
}

void Ppm::sampleDirectLight(std::uint32_t pass) {
    lightSampler_.sample(visiblePoints_, shared::kNone, pass, scene_.render.maxDepth);
    lightSampler_.trace(direct_);
    counts_.shadowRays += film_.pixelCount();
}

void Ppm::gatherPhotons(std::uint32_t pass, std::uint32_t slots) {
    const auto radius = static_cast<float>(searchRadius(initialRadius_, scene_.render.alpha, pass));
    grid_.build(device_, photonPaths_.photons(), slots, radius);
    counts_.photonsStored += grid_.photonCount();
    const std::uint32_t pixels = film_.pixelCount();
    device_.commands.run(gatherRadiance_,
                         shared::GatherRadianceArguments{visiblePoints_, grid_.cellStarts(), gathered_, grid_.record(),
                                                         radius, pixels, scene_.render.maxDepth},
                         pixels);
}

} // namespace hyalite::render
