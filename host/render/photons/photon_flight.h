// Photons in flight: followed from bounce to bounce, and stored where they land. What they do at their hits is the
// caller's.
#pragma once

#include "render/photons/photon_slots.h"
#include "render/upload/device_scene.h"
#include "render/wavefront/path_queue.h"

#include <functional>

namespace hyalite::render {

class PhotonFlight {
public:
    // References are kept. `atOnce`: photons in flight at most.
    PhotonFlight(Device& device, const DeviceScene& deviceScene, std::uint32_t atOnce);

    // Where a bounce stands.
    struct Bounce {
        std::uint32_t depth;       // segments from the light to the hits
        gpu::ThreadCount photons;  // that are in flight
        std::uint32_t firstPhoton; // see ScatterPhotonArguments
    };
    struct Course {
        std::uint32_t count;        // photons that start, capacity() at most
        std::uint32_t firstSlot;    // where their slots begin
        std::uint32_t maxDepth;     // segments
        bool storesFirst;           // else nothing is stored after the first segment: its slots are used again
        bool onlyOnce;              // the same photons must not be followed again
        std::function<void()> emit; // fills the queue
        std::function<void(const Bounce&)> atHits; // stores photons and writes the next rays, paths and alive flags
    };

    // Follows the photons to their ends and returns the slots that they fill, from firstSlot on. Finishes the commands.
    // The device counts the photons that go on, and so where slots begin. If there turn out to be more than were to be
    // expected from the photons before, it makes room and follows the same photons again.
    std::uint32_t follow(const Course& course);

    // Makes room for so many slots; see reservePhotonSlots. Throws Error(Device) where 32 bits do not number them.
    void reserve(std::uint64_t slots);

    [[nodiscard]] PhotonQueue& queue() { return queue_; }
    [[nodiscard]] const gpu::Array<shared::Photon>& photons() const { return photons_; }
    [[nodiscard]] std::uint32_t room() const { return static_cast<std::uint32_t>(photons_.count()); }
    [[nodiscard]] std::uint64_t raysTraced() const { return raysTraced_; }

private:
    // The queue's size at the end. `waits`: for the device at every bounce, to make room for what comes.
    [[nodiscard]] shared::QueueSize run(const Course& course, bool waits);
    void traceClosest(const gpu::ThreadCount& photons);

    Device& device_;
    const DeviceScene& deviceScene_;
    gpu::Kernel traceClosest_;
    Compaction compaction_;
    PhotonQueue queue_;
    gpu::Array<shared::Photon> photons_;
    double slotsPerPhoton_ = 0; // most so far; 0: none was followed
    std::uint64_t raysTraced_ = 0;
};

} // namespace hyalite::render
