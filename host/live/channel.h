// Messages between the live server and its worker: a JSON object and bytes, over a socket.
#pragma once

#include <cstddef>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

namespace hyalite::live {

using Json = nlohmann::json;

struct Message { // NOLINT(bugprone-exception-escape): no member throws when it is moved
    Json body;
    std::vector<std::byte> bytes;

    [[nodiscard]] std::string kind() const { return body.value("kind", std::string()); }
};

class Channel {
public:
    // Owns the socket.
    explicit Channel(int socket) : socket_(socket) {}
    ~Channel();
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;

    // From any thread. False: the other side is gone.
    bool send(const Json& body, std::span<const std::byte> bytes = {});

    // From one thread. Nothing: the other side is gone, or what it says is no message.
    [[nodiscard]] std::optional<Message> receive();

    // Ends the waiting of receive() on both sides.
    void close();

private:
    bool write(std::span<const std::byte> bytes);
    bool read(std::span<std::byte> bytes);

    int socket_;
    std::mutex sending_;
};

} // namespace hyalite::live
