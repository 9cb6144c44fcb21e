#include "render/wavefront/path_queue.h"

namespace hyalite::render {

RayQueue::RayQueue(const gpu::Context& context, std::uint32_t capacity, const std::string& name)
    : rays(context, capacity, name + " rays"), hits(context, capacity, name + " hits"),
      nextRays(context, capacity, name + " next rays"), alive(context, capacity, name + " alive"),
      offsets(context, std::size_t{capacity} + 1, name + " offsets") {}

CameraQueue::CameraQueue(const gpu::Context& context, std::uint32_t capacity)
    : RayQueue(context, capacity, "camera"), paths(context, capacity, "camera paths"),
      nextPaths(context, capacity, "next camera paths") {}

PhotonQueue::PhotonQueue(const gpu::Context& context, std::uint32_t capacity)
    : RayQueue(context, capacity, "photon"), paths(context, capacity, "photon paths"),
      nextPaths(context, capacity, "next photon paths") {}

std::uint32_t countAlive(Device& device, PrefixSum& prefixSum, const RayQueue& queue, std::uint32_t paths) {
    prefixSum.run(device, queue.alive, queue.offsets, paths);
    device.commands.finish();
    return queue.offsets.host()[paths];
}

} // namespace hyalite::render
