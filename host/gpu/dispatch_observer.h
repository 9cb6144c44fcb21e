// Observer of kernel dispatches: sees each kernel's arguments before it and its buffers after it.
#pragma once

#include "gpu/kernel.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace hyalite::gpu {

struct Dispatch {
    const Kernel& kernel;
    std::span<const std::byte> arguments; // the push constants; of a queue on the device, `count` is its size now
    std::uint32_t threads;                // > 0
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

    // Does it read the kernels' buffers? Then kernels also write what they could keep to themselves.
    [[nodiscard]] virtual bool readsBuffers() const { return true; }

    // A dispatch runs in pieces of at most this many threads; between() is called after each but the last, and may
    // throw to leave the rest out.
    [[nodiscard]] virtual std::uint32_t threadsOfPiece() const { return std::numeric_limits<std::uint32_t>::max(); }
    virtual void between() {}
};

// Keeps an observer registered with a command list; ends with its scope, however that is left. It may outlive the
// command list.
class [[nodiscard]] Observation {
public:
    Observation() = default;
    Observation(Observation&& other) noexcept
        : observers_(std::exchange(other.observers_, {})), observer_(std::exchange(other.observer_, nullptr)) {}
    Observation& operator=(Observation&& other) noexcept {
        if (this != &other) {
            end();
            observers_ = std::exchange(other.observers_, {});
            observer_ = std::exchange(other.observer_, nullptr);
        }
        return *this;
    }
    ~Observation() { end(); }

    void end() {
        if (const auto observers = observers_.lock()) {
            std::erase(*observers, observer_);
        }
        observers_.reset();
    }

private:
    friend class Commands;
    using Observers = std::vector<DispatchObserver*>;
    Observation(const std::shared_ptr<Observers>& observers, DispatchObserver* observer)
        : observers_(observers), observer_(observer) {
        observers->push_back(observer);
    }

    std::weak_ptr<Observers> observers_;
    DispatchObserver* observer_ = nullptr;
};

} // namespace hyalite::gpu
