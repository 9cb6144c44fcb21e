// A queue's number of elements, bounce after bounce. Only the device knows it: kernels are dispatched from it, and the
// host reads it only when necessary.
#pragma once

#include "render/wavefront/device.h"

#include "shaders/shared/queue.h"

#include <vector>

namespace hyalite::render {

class QueueSizes {
public:
    // Sizes for this many bounces, after which it wraps around; two suffice if the host does not look back.
    QueueSizes(const gpu::Context& context, std::uint32_t bounces, const std::string& name)
        : sizes_(context, std::size_t{bounces} * shared::kQueueLevels, name + " sizes"), bounces_(bounces) {}

    // Sets the queue to `count` elements, at the first bounce.
    void begin(Device& device, std::uint32_t count);

    // Advances to the next bounce, whose size a PrefixSum has computed by then; it has at most `most` elements, by
    // default at most as many as this bounce.
    void advance() { advance(most_); }
    void advance(std::uint32_t most);

    // The threads of a stage with one thread per element, or per chunk of kScanChunk^level elements.
    [[nodiscard]] gpu::ThreadCount threads(std::uint32_t level = 0) const;
    [[nodiscard]] shared::QueueSizeArray current() const { return at(bounce_); }
    [[nodiscard]] shared::QueueSizeArray next() const { return at((bounce_ + 1) % bounces_); }

    // Finishes the commands recorded so far and reads the present size.
    [[nodiscard]] shared::QueueSize read(Device& device);
    // The size of the next bounce. No command may be in flight.
    [[nodiscard]] shared::QueueSize readNext() const;
    // The numbers of elements in the first `count` bounces. No command may be in flight.
    [[nodiscard]] std::vector<std::uint32_t> counts(std::uint32_t count) const;

private:
    [[nodiscard]] shared::QueueSizeArray at(std::uint32_t bounce) const {
        return {sizes_.buffer().address() + std::size_t{bounce} * shared::kQueueLevels * sizeof(shared::QueueSize)};
    }

    gpu::Array<shared::QueueSize> sizes_; // kQueueLevels for each bounce
    std::uint32_t bounces_;
    std::uint32_t bounce_ = 0;
    std::uint32_t most_ = 0;
    bool isFirst_ = true; // the first bounce: the host knows the size
};

// This many bounces are recorded before the host checks whether any path is left. Later bounces of an empty queue cost
// little, and waiting for the device costs more (docs/performance.md).
inline constexpr std::uint32_t kBouncesAhead = 16;

// Should the host check the queue before the bounce of this number (from 1 on)? Always, if it waits for the device
// anyway.
[[nodiscard]] bool looksAtQueue(const Device& device, std::uint32_t bounce);

} // namespace hyalite::render
