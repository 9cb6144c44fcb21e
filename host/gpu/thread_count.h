// A dispatch's number of threads: known now, or read on the device when the dispatch begins.
#pragma once

#include "gpu/buffer.h"

#include "shaders/shared/queue.h"

namespace hyalite::gpu {

class ThreadCount {
public:
    ThreadCount(std::uint32_t threads)
        : most_(threads) {} // NOLINT(google-explicit-constructor): a number is a thread count
    // As many as sizes[index] says, `most` at most. The array must outlive the work.
    ThreadCount(const Array<shared::QueueSize>& sizes, std::size_t index, std::uint32_t most)
        : sizes_(&sizes.buffer()), offset_(index * sizeof(shared::QueueSize)), most_(most) {}

    [[nodiscard]] std::uint32_t most() const { return most_; }
    [[nodiscard]] bool isOnDevice() const { return sizes_ != nullptr; }

    // The `live` argument of kernels, see shared/kernel_arguments.h: null for a known number.
    [[nodiscard]] shared::QueueSizeArray live() const { return {sizes_ == nullptr ? 0 : sizes_->address() + offset_}; }

    // For a number on the device: the buffer of its shared::QueueSize.
    [[nodiscard]] const Buffer& sizes() const { return *sizes_; }
    [[nodiscard]] std::size_t offset() const { return offset_; }

private:
    const Buffer* sizes_ = nullptr;
    std::size_t offset_ = 0;
    std::uint32_t most_;
};

} // namespace hyalite::gpu
