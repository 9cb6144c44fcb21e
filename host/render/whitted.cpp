#include "render/whitted.h"

#include "scene/render_seed.h"

#include <utility>

namespace hyalite::render {

namespace {

constexpr std::uint32_t kSplit = 1; // both children of a dielectric are followed
constexpr std::uint32_t kChildren = 1 + kSplit;

} // namespace

Whitted::Level::Level(const gpu::Context& context, std::uint32_t capacity, std::uint32_t roughPointCount)
    : queue(context, capacity, kChildren), visiblePoints(context, capacity, "visible points"),
      roughPoints(context, roughPointCount, "rough points"), shadowRays(context, capacity, "shadow rays"),
      contributions(context, capacity, "light contributions"), emitted(context, capacity, "emitted light"),
      direct(context, capacity, "direct light") {}

Whitted::Whitted(Device& device, const Scene& scene, const DeviceScene& deviceScene, const Film& film)
    : device_(device), scene_(scene), deviceScene_(deviceScene), film_(film),
      generateCameraRays_(device.kernel("generate_camera_rays")),
      traceClosest_(device.kernel("trace_closest", deviceScene.specialization)),
      shadeSurface_(device.kernel("shade_surface", deviceScene.specialization)),
      sampleLights_(device.kernel("sample_lights", deviceScene.specialization)),
      traceShadow_(device.kernel("trace_shadow", deviceScene.specialization)), sumPaths_(device.kernel("sum_paths")),
      compaction_(device), roughLight_(device, deviceScene),
      level_(device.context, film.pixelCount(), roughLight_.points(film.pixelCount())),
      radiance_(device.context, film.pixelCount(), "radiance") {}

void Whitted::renderPass(std::uint32_t pass) {
    CameraQueue& queue = level_.queue;
    queue.count = film_.pixelCount();
    device_.commands.run(generateCameraRays_,
                         shared::GenerateCameraRaysArguments{queue.rays, queue.paths, renderSeed(scene_.render),
                                                             deviceScene_.camera, queue.count, pass},
                         queue.count);
    device_.commands.clear(radiance_.buffer());
    // One level of every pixel's tree of rays at a time
    for (std::uint32_t depth = 1; level_.queue.count > 0; ++depth) {
        // Hits, their emission, and the reflected and refracted rays that go on from them
        shade(pass, depth);
        // Light straight from every lamp onto diffuse and rough surfaces
        sampleEveryLight(pass);
        // Both belong to the pixel; the paths of a pixel stand together, so that their sum has one order
        device_.commands.run(
            sumPaths_,
            shared::SumPathsArguments{level_.queue.paths, level_.emitted, level_.direct, radiance_, level_.queue.count},
            level_.queue.count);
        descend();
    }
    film_.add(device_, 0, radiance_);
    device_.commands.finish();
}

void Whitted::shade(std::uint32_t pass, std::uint32_t depth) {
    CameraQueue& queue = level_.queue;
    const std::uint32_t width = deviceScene_.widthOf(queue.count);
    device_.commands.run(
        traceClosest_, shared::TraceClosestArguments{queue.rays, queue.hits, queue.count, deviceScene_.rootNode, width},
        queue.count);
    // The camera ray itself is neither reflection nor refraction
    const std::uint32_t maxDepth = scene_.render.maxDepth + 1;
    device_.commands.run(shadeSurface_,
                         shared::ShadeSurfaceArguments{queue.rays,
                                                       queue.hits,
                                                       queue.paths,
                                                       deviceScene_.materials,
                                                       deviceScene_.lights,
                                                       deviceScene_.normals,
                                                       deviceScene_.instances,
                                                       level_.visiblePoints,
                                                       level_.emitted,
                                                       queue.nextRays,
                                                       queue.nextPaths,
                                                       queue.alive,
                                                       queue.count,
                                                       depth,
                                                       maxDepth,
                                                       pass,
                                                       kSplit,
                                                       static_cast<float>(scene_.render.minWeight),
                                                       level_.roughPoints,
                                                       width},
                         queue.count);
    counts_.cameraRays += queue.count;
}

void Whitted::sampleEveryLight(std::uint32_t pass) {
    const std::uint32_t count = level_.queue.count;
    const std::uint32_t width = deviceScene_.widthOf(count);
    device_.commands.clear(level_.direct.buffer(), std::size_t{count} * sizeof(glm::vec3));
    for (std::uint32_t light = 0; light < deviceScene_.lightCount; ++light) {
        device_.commands.run(
            sampleLights_,
            shared::SampleLightsArguments{level_.visiblePoints, deviceScene_.lights, level_.shadowRays,
                                          level_.contributions, count, deviceScene_.lightCount, light, pass,
                                          /*maxDepth*/ scene_.render.maxDepth + 2, /*bounceDepth*/ 0, width},
            count);
        device_.commands.run(traceShadow_,
                             shared::TraceShadowArguments{level_.shadowRays, level_.contributions, level_.direct, count,
                                                          deviceScene_.rootNode, width},
                             count);
        counts_.shadowRays += count;
        counts_.shadowRays += roughLight_.sample(level_.roughPoints, level_.direct, count, light, pass);
    }
}

void Whitted::descend() {
    const std::uint32_t slots = kChildren * level_.queue.count;
    const std::uint32_t alive = compaction_.countAlive(device_, level_.queue, slots);
    if (alive <= level_.queue.capacity()) {
        compaction_.move(device_, level_.queue, level_.queue, slots, alive);
    } else { // a level of many splits: more room, kept for the passes to come
        const std::uint32_t capacity = alive + alive / 4;
        Level larger(device_.context, capacity, roughLight_.points(capacity));
        compaction_.move(device_, level_.queue, larger.queue, slots, alive);
        device_.commands.finish();
        level_ = std::move(larger);
    }
}

} // namespace hyalite::render
