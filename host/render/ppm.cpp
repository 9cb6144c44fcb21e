#include "render/ppm.h"

#include "scene/bounds.h"

#include <algorithm>
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
    : device_(device), scene_(scene), deviceScene_(deviceScene), film_(film), initialRadius_(initialRadius(scene)),
      generateCameraRays_(device.kernel("generate_camera_rays")),
      traceClosest_(device.kernel("trace_closest", deviceScene.specialization)),
      shadeSurface_(device.kernel("shade_surface", deviceScene.specialization)),
      compactCameraPaths_(device.kernel("compact_camera_paths")), sampleLights_(device.kernel("sample_lights")),
      traceShadow_(device.kernel("trace_shadow", deviceScene.specialization)),
      emitPhotons_(device.kernel("emit_photons")),
      scatterPhoton_(device.kernel("scatter_photon", deviceScene.specialization)),
      compactPhotonPaths_(device.kernel("compact_photon_paths")), gatherRadiance_(device.kernel("gather_radiance")),
      accumulateFilm_(device.kernel("accumulate_film")), prefixSum_(device), grid_(device),
      camera_(device.context, film.pixelCount(), 1), photonQueue_(device.context, scene.render.photons),
      visiblePoints_(device.context, film.pixelCount(), "visible points"),
      shadowRays_(device.context, film.pixelCount(), "shadow rays"),
      contributions_(device.context, film.pixelCount(), "light contributions"),
      emitted_(device.context, film.pixelCount(), "emitted light"),
      direct_(device.context, film.pixelCount(), "direct light"),
      gathered_(device.context, film.pixelCount(), "gathered light") {}

void Ppm::renderPass(std::uint32_t pass) {
    // Where each pixel's path first meets a diffuse surface, through mirrors and glass, and the emission on the way
    traceCameraPaths(pass);
    // Light that comes there straight from a lamp
    sampleDirectLight(pass);
    // Light that comes by way of other surfaces, as flux landing all over the scene …
    const std::uint32_t slots = tracePhotons(pass);
    // … whose density about each visible point is the rest of its light
    gatherPhotons(pass, slots);
    device_.commands.run(
        accumulateFilm_,
        shared::AccumulateFilmArguments{emitted_, direct_, gathered_, film_.sums(), film_.pixelCount()},
        film_.pixelCount());
    device_.commands.finish();
}

void Ppm::traceCameraPaths(std::uint32_t pass) {
    gpu::Commands& commands = device_.commands;
    CameraQueue& queue = camera_;
    queue.count = film_.pixelCount();
    commands.run(generateCameraRays_,
                 shared::GenerateCameraRaysArguments{queue.rays, queue.paths, deviceScene_.camera, queue.count,
                                                     scene_.render.seed, pass},
                 queue.count);
    for (std::uint32_t depth = 1; queue.count > 0; ++depth) {
        commands.run(traceClosest_,
                     shared::TraceClosestArguments{queue.rays, queue.hits, queue.count, deviceScene_.rootNode},
                     queue.count);
        commands.run(shadeSurface_,
                     shared::ShadeSurfaceArguments{queue.rays, queue.hits, queue.paths, deviceScene_.materials,
                                                   deviceScene_.lights, deviceScene_.normals, deviceScene_.instances,
                                                   visiblePoints_, emitted_, queue.nextRays, queue.nextPaths,
                                                   queue.alive, queue.count, depth, scene_.render.maxDepth, pass,
                                                   /*split*/ 0, /*minWeight*/ 0},
                     queue.count);
        counts_.cameraRays += queue.count;
        const std::uint32_t alive = countAlive(device_, prefixSum_, queue, queue.count);
        commands.run(compactCameraPaths_,
                     shared::CompactCameraPathsArguments{queue.alive, queue.offsets, queue.nextRays, queue.nextPaths,
                                                         queue.rays, queue.paths, queue.count},
                     alive > 0 ? queue.count : 0);
        queue.count = alive;
    }
}

void Ppm::sampleDirectLight(std::uint32_t pass) {
    gpu::Commands& commands = device_.commands;
    const std::uint32_t pixels = film_.pixelCount();
    commands.clear(direct_.buffer());
    commands.run(sampleLights_,
                 shared::SampleLightsArguments{visiblePoints_, deviceScene_.lights, shadowRays_, contributions_, pixels,
                                               deviceScene_.lightCount, shared::kNone, pass, scene_.render.maxDepth},
                 pixels);
    commands.run(traceShadow_,
                 shared::TraceShadowArguments{shadowRays_, contributions_, direct_, pixels, deviceScene_.rootNode},
                 pixels);
    counts_.shadowRays += pixels;
}

std::uint32_t Ppm::tracePhotons(std::uint32_t pass) {
    gpu::Commands& commands = device_.commands;
    PhotonQueue& queue = photonQueue_;
    const RenderSettings& settings = scene_.render;
    // Direct light is sampled from the visible points
    constexpr std::uint32_t kinds = 1U << shared::kPhotonIndirect | 1U << shared::kPhotonCaustic;
    const std::uint32_t sequence = shared::photonSequence(settings.seed, shared::kGlobalPhotons, pass);
    std::uint32_t slots = 0;
    queue.count = settings.photons;
    commands.run(emitPhotons_,
                 shared::EmitPhotonsArguments{deviceScene_.lights, queue.rays, queue.paths, queue.count,
                                              deviceScene_.lightCount, sequence},
                 queue.count);
    for (std::uint32_t depth = 1; queue.count > 0 && depth < settings.maxDepth; ++depth) {
        reservePhotons(slots + queue.count);
        commands.run(traceClosest_,
                     shared::TraceClosestArguments{queue.rays, queue.hits, queue.count, deviceScene_.rootNode},
                     queue.count);
        commands.run(scatterPhoton_,
                     shared::ScatterPhotonArguments{
                         queue.rays, queue.hits, queue.paths, deviceScene_.materials, deviceScene_.normals,
                         deviceScene_.instances, photons_, shared::PhotonFateArray{}, queue.nextRays, queue.nextPaths,
                         queue.alive, queue.count, slots, depth, settings.maxDepth, sequence, kinds, /*account*/ 0},
                     queue.count);
        counts_.photonRays += queue.count;
        // The first landing is direct light and stores nothing: its slots are used again
        slots += depth > 1 ? queue.count : 0;
        const std::uint32_t alive = countAlive(device_, prefixSum_, queue, queue.count);
        commands.run(compactPhotonPaths_,
                     shared::CompactPhotonPathsArguments{queue.alive, queue.offsets, queue.nextRays, queue.nextPaths,
                                                         queue.rays, queue.paths, queue.count},
                     alive > 0 ? queue.count : 0);
        queue.count = alive;
    }
    counts_.photonsEmitted += settings.photons;
    return slots;
}

void Ppm::gatherPhotons(std::uint32_t pass, std::uint32_t slots) {
    const auto radius = static_cast<float>(searchRadius(initialRadius_, scene_.render.alpha, pass));
    grid_.build(device_, photons_, slots, radius);
    counts_.photonsStored += grid_.photonCount();
    const std::uint32_t pixels = film_.pixelCount();
    device_.commands.run(gatherRadiance_,
                         shared::GatherRadianceArguments{visiblePoints_, grid_.cellStarts(), gathered_, grid_.record(),
                                                         radius, pixels, scene_.render.maxDepth},
                         pixels);
}

void Ppm::reservePhotons(std::uint32_t slots) {
    if (photons_.count() >= slots) {
        return;
    }
    device_.commands.finish();
    gpu::Array<shared::Photon> larger(device_.context, std::max<std::size_t>(slots, 2 * photons_.count()), "photons");
    std::ranges::copy(photons_.host(), larger.host().begin());
    photons_ = std::move(larger);
}

} // namespace hyalite::render
