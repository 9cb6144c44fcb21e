// How many threads a dispatch has: a number, or one that stands on the device when the dispatch begins.
#pragma once

#include "gpu/buffer.h"

#include "shaders/shared/queue.h"

namespace hyalite::gpu {

class ThreadCount {
public:
    ThreadCount(std::uint32_t threads) : most_(threads) {} // NOLINT(google-explicit-constructor): a number is one
    // As many as sizes[index] counts, `most` at most. The array must outlive the work.
    ThreadCount(const Array<shared::QueueSize>& sizes, std::size_t index, std::uint32_t most)
        : sizes_(&sizes.buffer()), offset_(index * sizeof(shared::QueueSize)), most_(most) {}

    [[nodiscard]] std::uint32_t most() const { return most_; }
    [[nodiscard]] bool isOnDevice() const { return sizes_ != nullptr; }

    // What kernels take for `live`, see shared/kernel_arguments.h: none for a number.
    [[nodiscard]] shared::QueueSizeArray live() const { return {sizes_ == nullptr ? 0 : sizes_->address() + offset_}; }

    // Of those on the device: where the shared::QueueSize stands.
    [[nodiscard]] const Buffer& sizes() const { return *sizes_; }
    [[nodiscard]] std::size_t offset() const { return offset_; }

private:
    const Buffer* sizes_ = nullptr;
    std::size_t offset_ = 0;
    std::uint32_t most_;
};

} // namespace hyalite::gpu
