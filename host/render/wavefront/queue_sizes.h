// How many elements a queue holds, bounce after bounce. The device alone knows: kernels are dispatched by it, and the
// host reads it only where it must.
#pragma once

#include "render/wavefront/device.h"

#include "shaders/shared/queue.h"

#include <vector>

namespace hyalite::render {

class QueueSizes {
public:
    // Of so many bounces, after which it starts over; two suffice where the host does not look back.
    QueueSizes(const gpu::Context& context, std::uint32_t bounces, const std::string& name)
        : sizes_(context, std::size_t{bounces} * shared::kQueueLevels, name + " sizes"), bounces_(bounces) {}

    // The queue has `count` elements now, at the first bounce.
    void begin(Device& device, std::uint32_t count);

    // On to the next bounce, whose size a PrefixSum has found by then; it has `most` elements at most, without one no
    // more than this one.
    void advance() { advance(most_); }
    void advance(std::uint32_t most);

    // The threads of a stage that takes an element each, or a chunk of kScanChunk^level elements.
    [[nodiscard]] gpu::ThreadCount threads(std::uint32_t level = 0) const;
    [[nodiscard]] shared::QueueSizeArray current() const { return at(bounce_); }
    [[nodiscard]] shared::QueueSizeArray next() const { return at((bounce_ + 1) % bounces_); }

    // Finishes the commands recorded so far and reads the present size.
    [[nodiscard]] shared::QueueSize read(Device& device);
    // The size that the next bounce has. No command may be in flight.
    [[nodiscard]] shared::QueueSize readNext() const;
    // The elements of the first `count` bounces. No command may be in flight.
    [[nodiscard]] std::vector<std::uint32_t> counts(std::uint32_t count) const;

private:
    [[nodiscard]] shared::QueueSizeArray at(std::uint32_t bounce) const {
        return {sizes_.buffer().address() + std::size_t{bounce} * shared::kQueueLevels * sizeof(shared::QueueSize)};
    }

    gpu::Array<shared::QueueSize> sizes_; // kQueueLevels for each bounce
    std::uint32_t bounces_;
    std::uint32_t bounce_ = 0;
    std::uint32_t most_ = 0;
    bool isFirst_ = true; // and the host knows the size
};

// So many bounces are recorded before the host looks whether any path is left. Later bounces of an empty queue cost
// little, and waiting for the device costs more (docs/performance.md).
inline constexpr std::uint32_t kBouncesAhead = 16;

// Is it time to look, before the bounce of this number (from 1 on)? Always, where the device is waited for anyway.
[[nodiscard]] bool looksAtQueue(const Device& device, std::uint32_t bounce);

} // namespace hyalite::render
