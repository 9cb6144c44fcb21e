#include "render/photons/photon_flight.h"

#include "base/error.h"

#include <algorithm>
#include <limits>
#include <string>

namespace hyalite::render {

namespace {

// How much more slots than before are to be expected: passes differ a little.
constexpr double kMoreSlots = 1.1;

} // namespace

PhotonFlight::PhotonFlight(Device& device, const DeviceScene& deviceScene, std::uint32_t atOnce)
    : device_(device), deviceScene_(deviceScene),
      traceClosest_(device.kernel("trace_closest", deviceScene.specialization)), compaction_(device),
      queue_(device.context, atOnce) {}

std::uint32_t PhotonFlight::follow(const Course& course) {
    if (course.count == 0) {
        return 0;
    }
    const double expected = kMoreSlots * slotsPerPhoton_ * double(course.count);
    bool waits = course.onlyOnce || slotsPerPhoton_ == 0 || device_.commands.runsOneByOne();
    if (!waits) {
        reserve(course.firstSlot + std::max(std::uint64_t{course.count}, static_cast<std::uint64_t>(expected)));
    }
    for (;;) {
        const shared::QueueSize end = run(course, waits);
        // Of the photons in flight at each bounce, those of the first may have used slots that are used again
        const std::uint32_t slots = end.before - (course.storesFirst ? 0 : std::min(course.count, end.before));
        if (waits || std::uint64_t{course.firstSlot} + slots <= room()) {
            slotsPerPhoton_ = std::max(slotsPerPhoton_, double(slots) / double(course.count));
            raysTraced_ += end.before;
            return slots;
        }
        waits = true;
    }
}

void PhotonFlight::reserve(std::uint64_t slots) {
    if (slots > std::numeric_limits<std::uint32_t>::max()) {
        throw Error(ExitCode::Device, "photons of one pass need " + std::to_string(slots) + " slots, more than 2^32",
                    "lower render.photons or render.max_depth");
    }
    reservePhotonSlots(device_, photons_, static_cast<std::uint32_t>(slots));
}

shared::QueueSize PhotonFlight::run(const Course& course, bool waits) {
    queue_.sizes.begin(device_, course.count);
    course.emit();
    for (std::uint32_t depth = 1; depth <= course.maxDepth; ++depth) {
        // Photons of later segments come after those of the first, or in their place
        const std::uint32_t before = depth > 1 && !course.storesFirst ? course.count : 0;
        if (waits) {
            const shared::QueueSize size = queue_.sizes.read(device_);
            if (size.count == 0) {
                break;
            }
            reserve(std::uint64_t{course.firstSlot} + size.before - before + size.count);
        } else if (looksAtQueue(device_, depth) && queue_.sizes.read(device_).count == 0) {
            break;
        }
        const gpu::ThreadCount photons = queue_.threads();
        traceClosest(photons);
        course.atHits({.depth = depth, .photons = photons, .firstPhoton = course.firstSlot - before});
        compaction_.run(device_, queue_);
    }
    return queue_.sizes.read(device_);
}

void PhotonFlight::traceClosest(const gpu::ThreadCount& photons) {
    device_.commands.run(traceClosest_,
                         shared::TraceClosestArguments{.rays = queue_.rays,
                                                       .hits = queue_.hits,
                                                       .count = photons.most(),
                                                       .rootNode = deviceScene_.rootNode,
                                                       .width = 0,
                                                       .live = photons.live()},
                         photons);
}

} // namespace hyalite::render
