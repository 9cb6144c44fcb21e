// Records kernels one after another, each seeing all that the ones before it wrote, and times each by name.
#pragma once

#include "gpu/dispatch_observer.h"
#include "gpu/kernel.h"

#include <map>

namespace hyalite::gpu {

struct StageTime {
    double seconds = 0;
    std::uint64_t dispatches = 0;
    std::uint64_t threads = 0;
};

class Commands {
public:
    Commands(const Context& context, const TexelTables& tables, bool timed = false);
    ~Commands();

    // Runs `kernel` on at least `threads` threads; a kernel asks for its number by threadIndex() and stops at its
    // count. Zero threads: nothing is recorded. sizeof(Arguments) must be the kernel's push-constant size, and the
    // tables it reads must be set in the format it reads them in.
    // The dispatch is cut into pieces that a GPU finishes in time; a barrier follows.
    template <class Arguments>
    void run(const Kernel& kernel, const Arguments& arguments, std::uint32_t threads) {
        static_assert(std::is_trivially_copyable_v<Arguments>);
        run(kernel, std::as_bytes(std::span(&arguments, 1)), threads);
    }
    // Makes the driver compile the kernel now, and runs nothing: lavapipe compiles at the first dispatch.
    void prepare(const Kernel& kernel);
    // Writes zeros to the whole buffer; a barrier follows.
    void clear(const Buffer& buffer);
    void clear(const Buffer& buffer, std::size_t bytes); // the first `bytes`, a multiple of 4

    // Submits what was recorded and waits: after that the host may read and write the buffers.
    // Throws Error(Device) when the device is lost.
    void finish();

    // While the returned Observation lives, `observer` sees every dispatch, and each is finished before the next is
    // recorded. Of several observers the first registered stands closest to the kernel: its before() comes last and its
    // after() first.
    [[nodiscard]] Observation observe(DispatchObserver& observer);

    // Does an observer read the kernels' buffers?
    [[nodiscard]] bool areBuffersRead() const;

    // Sums over all finished work, by kernel name; empty unless timed.
    [[nodiscard]] const std::map<std::string, StageTime>& times() const;

private:
    void run(const Kernel& kernel, std::span<const std::byte> arguments, std::uint32_t threads);
    struct Groups {
        std::uint32_t first = 0;
        std::uint32_t end = 0;     // > first
        std::uint32_t threads = 0; // of the kernel, in all groups: the last may not be full
    };
    void record(const Kernel& kernel, std::span<const std::byte> arguments, const Groups& groups);

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace hyalite::gpu
