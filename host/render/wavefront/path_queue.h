// Paths in flight, kept without gaps from bounce to bounce and always in the same order.
#pragma once

#include "render/wavefront/prefix_sum.h"

namespace hyalite::render {

// The part that does not depend on what a path carries.
struct RayQueue {
    gpu::Array<shared::Ray> rays;
    gpu::Array<shared::Hit> hits;
    gpu::Array<shared::Ray> nextRays;
    gpu::Array<shared::uint> alive;   // 1 where a next ray stands
    gpu::Array<shared::uint> offsets; // exclusive sums of alive
    QueueSizes sizes;                 // paths in flight

    RayQueue(const gpu::Context& context, std::uint32_t capacity, const std::string& name);
    [[nodiscard]] std::uint32_t capacity() const { return static_cast<std::uint32_t>(rays.count()); }

    // A thread for each path in flight.
    [[nodiscard]] gpu::ThreadCount threads() const { return sizes.threads(); }
};

struct CameraQueue : RayQueue {
    gpu::Array<shared::CameraPath> paths;
    gpu::Array<shared::CameraPath> nextPaths;

    CameraQueue(const gpu::Context& context, std::uint32_t capacity);
};

// So many photons fill both cores of a small machine and every GPU; the rest of a pass waits, and takes no room.
inline constexpr std::uint32_t kPhotonsInFlight = std::uint32_t{1} << 20U;

struct PhotonQueue : RayQueue {
    gpu::Array<shared::PhotonPath> paths;
    gpu::Array<shared::PhotonPath> nextPaths;

    PhotonQueue(const gpu::Context& context, std::uint32_t capacity);
};

// The end of a bounce: the next rays and paths that are alive become the queue, without gaps and in their order.
class Compaction {
public:
    explicit Compaction(Device& device) : compactPaths_(device.kernel("compact_paths")), prefixSum_(device) {}

    // `elementCount`: see PrefixSum::OfQueue.
    void run(Device& device, CameraQueue& queue, shared::UintArray elementCount = {});
    void run(Device& device, PhotonQueue& queue, shared::UintArray elementCount = {});

private:
    void run(Device& device, RayQueue& queue, shared::UintArray nextPaths, shared::UintArray paths,
             shared::UintArray elementCount);

    gpu::Kernel compactPaths_;
    PrefixSum prefixSum_;
};

} // namespace hyalite::render
