// Photons in flight: followed from bounce to bounce, and stored where they land. The caller decides what happens at
// their hits.
#pragma once

#include "render/photons/photon_slots.h"
#include "render/upload/device_scene.h"
#include "render/wavefront/path_queue.h"

#include <array>
#include <functional>

namespace hyalite::render {

class PhotonFlight {
public:
    // Keeps the references. `atOnce`: most photons in flight.
    PhotonFlight(Device& device, const DeviceScene& deviceScene, std::uint32_t atOnce);

    static constexpr std::uint32_t kKinds = 2;

    // The state of one bounce.
    struct Bounce {
        std::uint32_t depth;       // segments from the light to the hits
        gpu::ThreadCount photons;  // photons in flight
        std::uint32_t firstPhoton; // see ScatterPhotonArguments
    };
    struct Course {
        std::uint32_t kind;         // below kKinds: photons of one kind take about as many slots each
        std::uint32_t count;        // number of photons to start, at most capacity()
        std::uint32_t firstSlot;    // their first slot
        std::uint32_t maxDepth;     // segments
        bool storesFirst;           // photons are stored after the first segment; if not, its slots are reused
        bool onlyOnce;              // the same photons must not be followed a second time
        std::function<void()> emit; // fills the queue
        std::function<void(const Bounce&)> atHits; // stores photons and writes the next rays, paths and alive flags
    };

    // Follows the photons to their ends and returns the number of slots that they fill, from firstSlot on. Finishes the
    // commands. The device counts the surviving photons, and thereby the first slot of each bounce. If they are more
    // than expected from earlier photons, makes room and follows the same photons again.
    std::uint32_t follow(const Course& course);

    // Makes room for this many slots; see reservePhotonSlots. Throws Error(Device) if 32 bits cannot number them.
    void reserve(std::uint64_t slots);

    [[nodiscard]] PhotonQueue& queue() { return queue_; }
    [[nodiscard]] const gpu::Array<shared::Photon>& photons() const { return photons_; }
    [[nodiscard]] std::uint32_t room() const { return static_cast<std::uint32_t>(photons_.count()); }
    [[nodiscard]] std::uint64_t raysTraced() const { return raysTraced_; }

private:
    // Returns the queue's size at the end. `waits`: wait for the device at every bounce, to make room for the next one.
    [[nodiscard]] shared::QueueSize run(const Course& course, bool waits);
    void traceClosest(const gpu::ThreadCount& photons);

    Device& device_;
    const DeviceScene& deviceScene_;
    gpu::Kernel traceClosest_;
    Compaction compaction_;
    PhotonQueue queue_;
    gpu::Array<shared::Photon> photons_;
    // Largest number of slots per photon so far, by kind; 0: none of that kind was followed yet
    std::array<double, kKinds> slotsPerPhoton_{};
    std::uint64_t raysTraced_ = 0;
};

} // namespace hyalite::render
