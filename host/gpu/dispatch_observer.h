// Somebody who looks on while kernels run: what each is given, and what it leaves.
#pragma once

#include "gpu/kernel.h"

#include <cstddef>
#include <cstdint>
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
};

} // namespace hyalite::gpu
