// What happens to a live server, in the order in which its supervisor has to deal with it.
#pragma once

#include "live/messages/messages.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace hyalite::live {

// The worker's end of the channel was closed, or it sent what is not a message.
struct WorkerGone {
    std::string complaint; // about its last message; empty: it closed the channel
};
// The page's settings or view are different.
struct LookChanged {};
// The page's pixel is different, see PixelChosen.
struct PixelChanged {
    bool restarts = false;
};
// The server ends.
struct Closing {};

using Event = std::variant<WorkerMessage, WorkerGone, LookChanged, PixelChanged, InspectPixel, Closing>;

class EventQueue {
public:
    // From any thread.
    void push(Event event) {
        const std::scoped_lock lock(mutex_);
        events_.push_back(std::move(event));
        arrived_.notify_one();
    }

    // The oldest event; nothing when none arrives within `patience`.
    [[nodiscard]] std::optional<Event> take(std::chrono::milliseconds patience) {
        std::unique_lock lock(mutex_);
        if (!arrived_.wait_for(lock, patience, [&] { return !events_.empty(); })) {
            return std::nullopt;
        }
        Event event = std::move(events_.front());
        events_.pop_front();
        return event;
    }

    // Forgets what a worker sent that is no longer of interest.
    void dropWorkerEvents() {
        const std::scoped_lock lock(mutex_);
        std::erase_if(events_, [](const Event& event) {
            return std::holds_alternative<WorkerMessage>(event) || std::holds_alternative<WorkerGone>(event);
        });
    }

private:
    std::mutex mutex_;
    std::condition_variable arrived_;
    std::deque<Event> events_;
};

} // namespace hyalite::live
