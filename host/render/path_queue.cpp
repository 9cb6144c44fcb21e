#include "render/path_queue.h"

namespace hyalite::render {

RayQueue::RayQueue(const gpu::Context& context, std::uint32_t capacity, std::uint32_t children, const std::string& name)
    : rays(context, capacity, name + " rays"), hits(context, capacity, name + " hits"),
      nextRays(context, std::size_t{children} * capacity, name + " next rays"),
      alive(context, std::size_t{children} * capacity, name + " alive"),
      offsets(context, std::size_t{children} * capacity + 1, name + " offsets") {}

CameraQueue::CameraQueue(const gpu::Context& context, std::uint32_t capacity, std::uint32_t children)
    : RayQueue(context, capacity, children, "camera"), paths(context, capacity, "camera paths"),
      nextPaths(context, std::size_t{children} * capacity, "next camera paths") {}

PhotonQueue::PhotonQueue(const gpu::Context& context, std::uint32_t capacity)
    : RayQueue(context, capacity, 1, "photon"), paths(context, capacity, "photon paths"),
      nextPaths(context, capacity, "next photon paths") {}

std::uint32_t countAlive(Device& device, PrefixSum& prefixSum, const RayQueue& queue, std::uint32_t slots) {
    prefixSum.run(device, queue.alive, queue.offsets, slots);
    device.commands.finish();
    return queue.offsets.host()[slots];
}

} // namespace hyalite::render
