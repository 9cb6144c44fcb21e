#include "render/integrators/path.h"

namespace hyalite::render {

PathTracing::PathTracing(Device& device, const Scene& scene, const DeviceScene& deviceScene, const Film& film)
    : device_(device), scene_(scene), deviceScene_(deviceScene), film_(film),
      cameraPaths_(device, scene, deviceScene, film.pixelCount(), AtDiffuse::Bounces),
      lightSampler_(device, deviceScene, film.pixelCount()),
      bouncePaths_(device.kernel("bounce_paths", deviceScene.specialization)),
      visiblePoints_(device.context, film.pixelCount(), "visible points"),
      met_(device.context, film.pixelCount(), "light met"),
      sampled_(device.context, film.pixelCount(), "light sampled") {}

void PathTracing::renderPass(std::uint32_t pass) {
    const std::uint32_t maxDepth = scene_.render.maxDepth;
    device_.commands.clear(sampled_.buffer());
    cameraPaths_.generate(pass);
    const RaysTraced rays = cameraPaths_.follow(pass, visiblePoints_, met_, &sampled_, [&](std::uint32_t depth) {
        const CameraQueue& queue = cameraPaths_.queue();
        // Light that a shadow ray brings to the diffuse surfaces that paths have just come to …
        lightSampler_.sample(visiblePoints_, shared::kNone, pass, maxDepth, depth);
        lightSampler_.trace(sampled_);
        counts_.shadowRays += queue.count;
        // … and the ways on from there
        device_.commands.run(bouncePaths_,
                             shared::BouncePathsArguments{queue.paths, visiblePoints_, deviceScene_.materials,
                                                          queue.nextRays, queue.nextPaths, queue.alive, queue.count,
                                                          depth, maxDepth, pass},
                             queue.count);
    });
    counts_.cameraRays += rays.camera;
    counts_.shadowRays += rays.shadow;
    film_.add(device_, 0, met_);
    film_.add(device_, 1, sampled_);
    device_.commands.finish();
}

} // namespace hyalite::render
