#include "live/worker/inbox.h"

#include <cstdio>
#include <unistd.h>
#include <utility>

namespace hyalite::live {

Inbox::Inbox(Channel& channel) : channel_(channel), reader_([this] { read(); }) {}

Inbox::~Inbox() {
    isEnding_ = true;
    channel_.close();
    reader_.join();
}

void Inbox::read() {
    ExitCode code = ExitCode::Done;
    try {
        while (std::optional<Packet> packet = channel_.receive()) {
            ServerMessage message = readServerMessage(*std::move(packet));
            const bool keepsPicture =
                std::holds_alternative<InspectPixel>(message) || std::holds_alternative<PixelChosen>(message);
            const std::scoped_lock lock(mutex_);
            isUnwanted_ = isUnwanted_ || !keepsPicture;
            messages_.push_back(std::move(message));
            arrived_.notify_one();
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "hyalite live-worker: %s\n", error.what());
        code = ExitCode::BadInput;
    }
    if (!isEnding_) {
        ::_exit(static_cast<int>(code));
    }
}

std::optional<ServerMessage> Inbox::take(bool wait) {
    std::unique_lock lock(mutex_);
    if (wait) {
        arrived_.wait(lock, [&] { return !messages_.empty(); });
    }
    if (messages_.empty()) {
        isUnwanted_ = false;
        return std::nullopt;
    }
    ServerMessage message = std::move(messages_.front());
    messages_.pop_front();
    return message;
}

} // namespace hyalite::live
