// Paths in flight, kept without gaps from bounce to bounce and always in the same order.
#pragma once

#include "render/prefix_sum.h"

namespace hyalite::render {

// The part that does not depend on what a path carries.
struct RayQueue {
    gpu::Array<shared::Ray> rays;
    gpu::Array<shared::Hit> hits;
    gpu::Array<shared::Ray> nextRays;
    gpu::Array<shared::uint> alive;   // 1 where a next ray stands
    gpu::Array<shared::uint> offsets; // exclusive sums of alive
    std::uint32_t count = 0;          // paths in flight

    // `children`: next rays that one path may leave.
    RayQueue(const gpu::Context& context, std::uint32_t capacity, std::uint32_t children, const std::string& name);
    [[nodiscard]] std::uint32_t capacity() const { return static_cast<std::uint32_t>(rays.count()); }
};

struct CameraQueue : RayQueue {
    gpu::Array<shared::CameraPath> paths;
    gpu::Array<shared::CameraPath> nextPaths;

    CameraQueue(const gpu::Context& context, std::uint32_t capacity, std::uint32_t children);
};

struct PhotonQueue : RayQueue {
    gpu::Array<shared::PhotonPath> paths;
    gpu::Array<shared::PhotonPath> nextPaths;

    PhotonQueue(const gpu::Context& context, std::uint32_t capacity);
};

// Finds out how many of `slots` next rays are alive; the commands recorded so far are finished by that.
[[nodiscard]] std::uint32_t countAlive(Device& device, PrefixSum& prefixSum, const RayQueue& queue,
                                       std::uint32_t slots);

} // namespace hyalite::render
