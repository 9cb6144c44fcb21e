// The messages from the server, read by a thread of their own: a change must be noticed while a pass runs.
#pragma once

#include "live/messages/messages.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

namespace hyalite::live {

class Inbox {
public:
    // The reference is kept. When the server is gone, or sends what is not a message, the process ends at once, even
    // while a kernel hangs: nobody waits for its result any more.
    explicit Inbox(Channel& channel);
    ~Inbox(); // closes the channel, and waits for the thread
    Inbox(const Inbox&) = delete;
    Inbox& operator=(const Inbox&) = delete;

    // Whether a message is waiting that changes the picture, so that the present pass is not wanted any more.
    [[nodiscard]] bool isUnwanted() const { return isUnwanted_; }

    // The oldest message; with `wait` as soon as there is one, else nothing when there is none.
    [[nodiscard]] std::optional<ServerMessage> take(bool wait);

private:
    void read();

    Channel& channel_;
    std::mutex mutex_;
    std::condition_variable arrived_;
    std::deque<ServerMessage> messages_;
    std::atomic<bool> isUnwanted_ = false;
    std::atomic<bool> isEnding_ = false;
    std::thread reader_;
};

} // namespace hyalite::live
