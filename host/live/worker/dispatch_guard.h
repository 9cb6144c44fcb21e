// Observes the worker's kernels: publishes which one runs, so that the server can tell what hangs; interrupts a pass
// that nobody wants any more; collects what kernels print.
#pragma once

#include "gpu/dispatch_observer.h"
#include "live/messages/pulse.h"
#include "live/worker/debug_prints.h"

#include <functional>
#include <utility>

namespace hyalite::live {

// The worker's activity between two kernels, which includes waiting for kernels to be compiled.
inline constexpr const char* kBetweenKernels = "preparing kernels";

// Thrown out of a pass that is given up.
struct Interrupted {};

class DispatchGuard final : public gpu::DispatchObserver {
public:
    // References are kept. `isUnwanted`: whether a pass that may be interrupted should be.
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

    // A piece takes 10 to 20 ms on two cores: a user who drags the camera waits no longer than that for an
    // interruption.
    [[nodiscard]] std::uint32_t threadsOfPiece() const override { return 1U << 14U; }
    void between() override {
        if (mayInterrupt_ && isUnwanted_()) {
            throw Interrupted();
        }
    }

    // Whether passes may be interrupted from now on.
    void mayInterrupt(bool may) { mayInterrupt_ = may; }

    // While it exists, however it ends, passes are not interrupted.
    class Uninterrupted {
    public:
        explicit Uninterrupted(DispatchGuard& guard)
            : guard_(guard), couldInterrupt_(std::exchange(guard.mayInterrupt_, false)) {}
        ~Uninterrupted() { guard_.mayInterrupt_ = couldInterrupt_; }
        Uninterrupted(const Uninterrupted&) = delete;
        Uninterrupted& operator=(const Uninterrupted&) = delete;

    private:
        DispatchGuard& guard_;
        bool couldInterrupt_;
    };

private:
    Pulse& pulse_;
    DebugPrints& prints_;
    std::function<bool()> isUnwanted_;
    bool mayInterrupt_ = false;
};

} // namespace hyalite::live
