#include "bench/ray_sets.h"

#include "render/wavefront/camera_paths.h"
#include "render/wavefront/light_sampler.h"

#include "shaders/shared/pixel_order.h"

#include <random>

namespace hyalite::bench {

namespace {

// Far enough for a bounce after the first hit.
constexpr std::uint32_t kSegments = 3;

// The rays of a picture's pixels in the order in which threads take them.
std::vector<shared::Ray> inTiles(std::span<const shared::Ray> pixels, std::uint32_t width) {
    std::vector<shared::Ray> rays;
    const auto count = static_cast<std::uint32_t>(pixels.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        rays.push_back(pixels[shared::pixelOfThread(i, i / (shared::kTileSide * width), width, count)]);
    }
    return rays;
}

// By a generator that the standard defines, so the same everywhere; its modulus is biased by 2^-40.
std::vector<shared::Ray> shuffled(std::vector<shared::Ray> rays) {
    std::mt19937_64 random(1);
    for (std::size_t i = rays.size(); i > 1; --i) {
        std::swap(rays[i - 1], rays[random() % i]);
    }
    return rays;
}

} // namespace

std::vector<RaySet> makeRaySets(render::Device& device, const Scene& scene, const render::DeviceScene& deviceScene) {
    const std::uint32_t pixels = scene.camera.resolution.x * scene.camera.resolution.y;
    const std::uint32_t width = scene.camera.resolution.x;
    Scene settings; // CameraPaths reads nothing else of it
    settings.render = scene.render;
    settings.render.maxDepth = kSegments;
    render::CameraPaths paths(device, settings, deviceScene, pixels, {}, render::AtDiffuse::Bounces);
    render::LightSampler lights(device, deviceScene, pixels, {});
    const gpu::Kernel bouncePaths = device.kernel("bounce_paths", deviceScene.specialization);
    const gpu::Array<shared::VisiblePoint> visiblePoints(device.context, pixels, "visible points");
    const gpu::Array<glm::vec3> met(device.context, pixels, "light met");

    std::vector<RaySet> sets;
    paths.generate(0);
    device.commands.finish();
    sets.push_back({"camera", false, inTiles(paths.queue().rays.read(0, pixels), width)});
    paths.follow(0, visiblePoints, met, nullptr, [&](std::uint32_t depth) {
        render::CameraQueue& queue = paths.queue();
        const gpu::ThreadCount threads = queue.threads();
        device.commands.run(bouncePaths,
                            shared::BouncePathsArguments{.paths = queue.paths,
                                                         .visiblePoints = visiblePoints,
                                                         .materials = deviceScene.materials,
                                                         .nextRays = queue.nextRays,
                                                         .nextPaths = queue.nextPaths,
                                                         .alive = queue.alive,
                                                         .count = threads.most(),
                                                         .depth = depth,
                                                         .maxDepth = kSegments,
                                                         .pass = 0,
                                                         .live = threads.live()},
                            threads);
        if (depth == 1) {
            lights.sample(visiblePoints, shared::kNone, 0, kSegments);
            device.commands.finish();
            RaySet shadow{"shadow", true, inTiles(lights.shadowRays().read(), width)};
            std::erase_if(shadow.rays, [](const shared::Ray& ray) { return ray.tMax <= 0; });
            sets.push_back(std::move(shadow));
        }
        if (depth == 2) {
            sets.push_back({"bounce", false, queue.rays.read(0, queue.sizes.read(device).count)});
            sets.push_back({"shuffled", false, shuffled(sets.back().rays)});
        }
    });
    device.commands.finish();
    std::erase_if(sets, [](const RaySet& set) { return set.rays.empty(); });
    return sets;
}

} // namespace hyalite::bench
