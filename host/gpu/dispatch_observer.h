// Somebody who looks on while kernels run: what each is given, and what it leaves.
#pragma once

#include "gpu/kernel.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace hyalite::gpu {

struct Dispatch {
    const Kernel& kernel;
    std::span<const std::byte> arguments; // the push constants
    std::uint32_t threads;
};

// Called on either side of a dispatch, when nothing runs: buffers may be read, but not written.
class DispatchObserver {
public:
    DispatchObserver() = default;
    DispatchObserver(const DispatchObserver&) = delete;
    DispatchObserver& operator=(const DispatchObserver&) = delete;
    virtual ~DispatchObserver() = default;

    virtual void before(const Dispatch& dispatch) = 0;
    virtual void after(const Dispatch& dispatch) = 0;

    // Does it look at what kernels read and write? Then they write also what they could keep to themselves.
    [[nodiscard]] virtual bool readsBuffers() const { return true; }

    // A dispatch runs in pieces of at most so many threads, and between() is called when one is done: it may throw to
    // have the rest left out.
    [[nodiscard]] virtual std::uint32_t threadsOfPiece() const { return std::numeric_limits<std::uint32_t>::max(); }
    virtual void between() {}
};

} // namespace hyalite::gpu
