#include "render/wavefront/path_queue.h"

namespace hyalite::render {

RayQueue::RayQueue(const gpu::Context& context, std::uint32_t capacity, const std::string& name)
    : rays(context, capacity, name + " rays"), hits(context, capacity, name + " hits"),
      nextRays(context, capacity, name + " next rays"), alive(context, capacity, name + " alive"),
      offsets(context, std::size_t{capacity} + 1, name + " offsets"), sizes(context, 2, name) {}

CameraQueue::CameraQueue(const gpu::Context& context, std::uint32_t capacity)
    : RayQueue(context, capacity, "camera"), paths(context, capacity, "camera paths"),
      nextPaths(context, capacity, "next camera paths") {}

PhotonQueue::PhotonQueue(const gpu::Context& context, std::uint32_t capacity)
    : RayQueue(context, capacity, "photon"), paths(context, capacity, "photon paths"),
      nextPaths(context, capacity, "next photon paths") {}

static_assert(sizeof(shared::CameraPath) == shared::kPathWords * sizeof(shared::uint));
static_assert(sizeof(shared::PhotonPath) == shared::kPathWords * sizeof(shared::uint));

void Compaction::run(Device& device, CameraQueue& queue, shared::UintArray elementCount) {
    run(device, queue, queue.nextPaths, queue.paths, elementCount);
}

void Compaction::run(Device& device, PhotonQueue& queue, shared::UintArray elementCount) {
    run(device, queue, queue.nextPaths, queue.paths, elementCount);
}

void Compaction::run(Device& device, RayQueue& queue, shared::UintArray nextPaths, shared::UintArray paths,
                     shared::UintArray elementCount) {
    prefixSum_.run(device, queue.alive, queue.offsets, {.sizes = queue.sizes, .elementCount = elementCount});
    const gpu::ThreadCount threads = queue.threads();
    device.commands.run(compactPaths_,
                        shared::CompactPathsArguments{.alive = queue.alive,
                                                      .offsets = queue.offsets,
                                                      .nextRays = queue.nextRays,
                                                      .nextPaths = nextPaths,
                                                      .rays = queue.rays,
                                                      .paths = paths,
                                                      .count = threads.most(),
                                                      .live = threads.live()},
                        threads);
    queue.sizes.advance();
}

} // namespace hyalite::render
