// Carries packets between the live server and its worker: a JSON object and bytes, over a socket.
#pragma once

#include "live/messages/record.h"

#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace hyalite::live {

struct Packet { // NOLINT(bugprone-exception-escape): no member throws when it is moved
    Json body;
    std::vector<std::byte> bytes;
};

class Channel {
public:
    // Owns the socket.
    explicit Channel(int socket) : socket_(socket) {}
    ~Channel();
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;

    // May be called from any thread. Returns false when the other side is gone.
    bool send(const Json& body, std::span<const std::byte> bytes = {});

    // Waits for a packet; to be called from one thread. Returns nothing when the other side is gone or the channel is
    // closed. Throws Error(BadInput) when what arrives is not a packet.
    [[nodiscard]] std::optional<Packet> receive();

    // Ends receive() on both sides.
    void close();

private:
    bool write(std::span<const std::byte> bytes);
    bool read(std::span<std::byte> bytes);

    int socket_;
    std::mutex sending_;
};

} // namespace hyalite::live
