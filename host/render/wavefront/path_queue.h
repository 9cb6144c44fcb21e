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
    std::uint32_t count = 0;          // paths in flight

    RayQueue(const gpu::Context& context, std::uint32_t capacity, const std::string& name);
    [[nodiscard]] std::uint32_t capacity() const { return static_cast<std::uint32_t>(rays.count()); }
};

// Sums up which of the first `paths` next rays are alive, and how many; finishes the commands recorded so far.
[[nodiscard]] std::uint32_t countAlive(Device& device, PrefixSum& prefixSum, const RayQueue& queue,
                                       std::uint32_t paths);

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

// The end of a bounce: the living of the next rays and paths become the queue, without gaps and in their order.
template <class Queue, class Arguments>
class Compaction {
public:
    // `kernel`: the one that takes the arguments.
    Compaction(const Device& device, const std::string& kernel) : kernel_(device.kernel(kernel)), prefixSum_(device) {}

    // Of the next rays that `paths` may have left; finishes the commands recorded so far.
    void run(Device& device, Queue& queue, std::uint32_t paths) {
        const std::uint32_t alive = countAlive(device, prefixSum_, queue, paths);
        device.commands.run(
            kernel_,
            Arguments{queue.alive, queue.offsets, queue.nextRays, queue.nextPaths, queue.rays, queue.paths, paths},
            alive > 0 ? paths : 0);
        queue.count = alive;
    }

private:
    gpu::Kernel kernel_;
    PrefixSum prefixSum_;
};

struct CameraCompaction : Compaction<CameraQueue, shared::CompactCameraPathsArguments> {
    explicit CameraCompaction(const Device& device) : Compaction(device, "compact_camera_paths") {}
};

struct PhotonCompaction : Compaction<PhotonQueue, shared::CompactPhotonPathsArguments> {
    explicit PhotonCompaction(const Device& device) : Compaction(device, "compact_photon_paths") {}
};

} // namespace hyalite::render
