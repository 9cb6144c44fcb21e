#include "render/wavefront/queue_sizes.h"

#include <algorithm>
#include <array>

namespace hyalite::render {

using shared::kQueueLevels;

void QueueSizes::begin(Device& device, std::uint32_t count) {
    std::array<shared::QueueSize, kQueueLevels> sizes{};
    std::uint32_t elements = count;
    for (shared::QueueSize& size : sizes) {
        size = shared::queueSize(elements, 0);
        elements = shared::chunksOf(elements);
    }
    device.commands.set(sizes_, std::span<const shared::QueueSize>(sizes));
    bounce_ = 0;
    most_ = count;
    isFirst_ = true;
}

void QueueSizes::advance(std::uint32_t most) {
    bounce_ = (bounce_ + 1) % bounces_;
    most_ = most;
    isFirst_ = false;
}

gpu::ThreadCount QueueSizes::threads(std::uint32_t level) const {
    std::uint32_t most = most_;
    for (std::uint32_t i = 0; i < level; ++i) {
        most = shared::chunksOf(most);
    }
    if (isFirst_) { // by the number: kernels need not look it up
        return most;
    }
    return {sizes_, std::size_t{bounce_} * kQueueLevels + level, most};
}

shared::QueueSize QueueSizes::read(Device& device) {
    device.commands.finish();
    return sizes_.read(std::size_t{bounce_} * kQueueLevels);
}

shared::QueueSize QueueSizes::readNext() const {
    return sizes_.read(std::size_t{(bounce_ + 1) % bounces_} * kQueueLevels);
}

std::vector<std::uint32_t> QueueSizes::counts(std::uint32_t count) const {
    std::vector<std::uint32_t> counts;
    for (const shared::QueueSize& size : sizes_.read(0, std::size_t{count} * kQueueLevels)) {
        counts.push_back(size.count);
    }
    for (std::size_t i = 0; i < count; ++i) {
        counts[i] = counts[i * kQueueLevels];
    }
    counts.resize(count);
    return counts;
}

bool looksAtQueue(const Device& device, std::uint32_t bounce) {
    return bounce > 1 && (device.commands.runsOneByOne() || (bounce - 1) % kBouncesAhead == 0);
}

} // namespace hyalite::render
