// Looks on while a worker's kernels run: says which one does, so that another process can tell what hangs; stops a pass
// that nobody waits for any more; and collects what kernels print.
#pragma once

#include "gpu/dispatch_observer.h"
#include "live/debug_prints.h"
#include "live/pulse.h"

#include <atomic>
#include <functional>

namespace hyalite::live {

// Waiting for one to be made, among other things.
inline constexpr const char* kBetweenKernels = "preparing kernels";

// Thrown out of a pass that is to be given up.
struct Interrupted {};

class DispatchGuard final : public gpu::DispatchObserver {
public:
    // References are kept. A pass that may be interrupted is where `isUnwanted` says so.
    DispatchGuard(Pulse& pulse, DebugPrints& prints, std::function<bool()> isUnwanted)
        : pulse_(pulse), prints_(prints), isUnwanted_(std::move(isUnwanted)) {}

    void before(const gpu::Dispatch& dispatch) override {
        between();
        pulse_.begin(dispatch.kernel.name(), true);
    }
    void after(const gpu::Dispatch& dispatch) override {
        pulse_.begin(kBetweenKernels, false);
        prints_.collect(dispatch.kernel.name());
    }

    [[nodiscard]] bool readsBuffers() const override { return false; }

    // A piece takes ten or twenty milliseconds on two cores: so long at most does somebody wait who drags the camera.
    [[nodiscard]] std::uint32_t threadsOfPiece() const override { return 1U << 14U; }
    void between() override {
        if (mayStop_ && isUnwanted_()) {
            throw Interrupted();
        }
    }

    void mayStop(bool may) { mayStop_ = may; }

private:
    Pulse& pulse_;
    DebugPrints& prints_;
    std::function<bool()> isUnwanted_;
    bool mayStop_ = false;
};

} // namespace hyalite::live
