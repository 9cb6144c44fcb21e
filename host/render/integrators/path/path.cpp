#include "render/integrators/path/path.h"

#include "reference/integrators/path.h"

namespace hyalite::render {

IntegratorKind PathTracing::kind() {
    return {.name = "path",
            .layers = [](const RenderSettings&) -> std::vector<LayerKind> { return {{"met"}, {"sampled"}}; },
            .make = makeIntegrator<PathTracing>,
            .reference = reference::renderPath};
}

PathTracing::PathTracing(const IntegratorInput& input)
    : device_(input.device), scene_(input.scene), deviceScene_(input.deviceScene), film_(input.film),
      cameraPaths_(device_, scene_, input.deviceScene, film_.pixelCount(), film_.sought(), AtDiffuse::Bounces),
      lightSampler_(device_, input.deviceScene, film_.pixelCount(), film_.sought()),
      bouncePaths_(device_.kernel("bounce_paths", deviceScene_.specialization)),
      visiblePoints_(device_.context, film_.pixelCount(), "visible points"),
      met_(device_.context, film_.pixelCount(), "light met"),
      sampled_(device_.context, film_.pixelCount(), "light sampled") {}

void PathTracing::renderPass(std::uint32_t pass) {
    const std::uint32_t maxDepth = scene_.render.maxDepth;
    device_.commands.clear(sampled_.buffer());
    cameraPaths_.generate(pass);
    cameraPaths_.follow(pass, visiblePoints_, met_, &sampled_, [&](std::uint32_t depth) {
        const CameraQueue& queue = cameraPaths_.queue();
        // Next event: light that a shadow ray brings to the diffuse surfaces that paths have just reached …
        lightSampler_.sample(visiblePoints_, queue, pass, maxDepth, depth);
        lightSampler_.trace(sampled_, queue);
        // … and the paths' next directions from there
        const gpu::ThreadCount threads = queue.threads();
        device_.commands.run(bouncePaths_,
                             shared::BouncePathsArguments{.paths = queue.paths,
                                                          .visiblePoints = visiblePoints_,
                                                          .materials = deviceScene_.materials,
                                                          .nextRays = queue.nextRays,
                                                          .nextPaths = queue.nextPaths,
                                                          .alive = queue.alive,
                                                          .count = threads.most(),
                                                          .depth = depth,
                                                          .maxDepth = maxDepth,
                                                          .pass = pass,
                                                          .live = threads.live()},
                             threads);
    });
    film_.add(device_, 0, met_);
    film_.add(device_, 1, sampled_);
    device_.commands.finish();
    const RaysTraced rays = cameraPaths_.raysTraced();
    counts_[Counter::CameraRays] = rays.camera;
    counts_[Counter::ShadowRays] = rays.shadow + lightSampler_.raysTraced();
}

} // namespace hyalite::render
