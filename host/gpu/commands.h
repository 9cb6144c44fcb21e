// Records kernels one after another, each seeing all that the ones before it wrote, and times each by name.
#pragma once

#include "gpu/dispatch_observer.h"
#include "gpu/kernel.h"
#include "gpu/thread_count.h"

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
    // The dispatch is cut into pieces that a GPU finishes in time; a barrier follows. A number that stands on the
    // device is read there when the dispatch begins; only where it may be larger than a GPU finishes at once does run()
    // wait for it.
    template <class Arguments>
    void run(const Kernel& kernel, const Arguments& arguments, const ThreadCount& threads) {
        static_assert(std::is_trivially_copyable_v<Arguments>);
        run(kernel, std::as_bytes(std::span(&arguments, 1)), threads);
    }
    // Makes the driver compile the kernel now, and runs nothing: lavapipe compiles at the first dispatch.
    void prepare(const Kernel& kernel);
    // Writes zeros to the whole buffer; a barrier follows.
    void clear(const Buffer& buffer);
    void clear(const Buffer& buffer, std::size_t bytes); // the first `bytes`, a multiple of 4
    // Copies the whole of a buffer to the beginning of one that is as large; a barrier follows. Of an empty one,
    // nothing.
    void copy(const Buffer& from, const Buffer& to);
    // Writes the values, 65 536 bytes at most, to the beginning of the array when what was recorded before is done; a
    // barrier follows.
    template <class T>
    void set(const Array<T>& array, std::span<const T> values) {
        set(array.buffer(), std::as_bytes(values));
    }

    // Submits what was recorded and waits: after that the host may read and write the buffers.
    // Throws Error(Device) when the device is lost.
    void finish();

    // While the returned Observation lives, `observer` sees every dispatch, and each is finished before the next is
    // recorded. Of several observers the first registered stands closest to the kernel: its before() comes last and its
    // after() first.
    [[nodiscard]] Observation observe(DispatchObserver& observer);

    // Is each dispatch finished before the next is recorded, so that the host may look at any time what it left?
    [[nodiscard]] bool runsOneByOne() const;
    // Does an observer read the kernels' buffers?
    [[nodiscard]] bool areBuffersRead() const;

    // Sums over all finished work, by kernel name; empty unless timed.
    [[nodiscard]] const std::map<std::string, StageTime>& times() const;

private:
    void run(const Kernel& kernel, std::span<const std::byte> arguments, const ThreadCount& threads);
    void runAlone(const Kernel& kernel, std::span<const std::byte> arguments, std::uint32_t threads);
    void set(const Buffer& buffer, std::span<const std::byte> bytes);
    struct Groups {
        std::uint32_t first = 0;
        std::uint32_t end = 0;     // > first
        std::uint32_t threads = 0; // of the kernel, in all groups: the last may not be full
    };
    void record(const Kernel& kernel, std::span<const std::byte> arguments, const Groups& groups);
    void recordIndirect(const Kernel& kernel, std::span<const std::byte> arguments, const ThreadCount& threads);

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace hyalite::gpu
