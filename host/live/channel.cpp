// A message is two lengths of 8 bytes, the JSON as text, and the bytes.
#include "live/channel.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <sys/socket.h>
#include <unistd.h>

namespace hyalite::live {

namespace {

// A picture of all layers and 2^24 pixels; longer is no message of ours.
constexpr std::uint64_t kLongest = std::uint64_t{1} << 31U;

} // namespace

Channel::~Channel() {
    ::close(socket_);
}

void Channel::close() {
    ::shutdown(socket_, SHUT_RDWR);
}

bool Channel::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) {
            continue;
        }
        if (sent <= 0) {
            return false;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

bool Channel::read(std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t received = ::recv(socket_, bytes.data(), bytes.size(), 0);
        if (received < 0 && errno == EINTR) {
            continue;
        }
        if (received <= 0) {
            return false;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(received));
    }
    return true;
}

bool Channel::send(const Json& body, std::span<const std::byte> bytes) {
    // What came from files may be no UTF-8
    const std::string text = body.dump(-1, ' ', false, Json::error_handler_t::replace);
    const std::array<std::uint64_t, 2> lengths{text.size(), bytes.size()};
    const std::scoped_lock lock(sending_);
    return write(std::as_bytes(std::span(lengths))) && write(std::as_bytes(std::span(text))) && write(bytes);
}

std::optional<Message> Channel::receive() {
    std::array<std::uint64_t, 2> lengths{};
    if (!read(std::as_writable_bytes(std::span(lengths))) || lengths[0] > kLongest || lengths[1] > kLongest) {
        return std::nullopt;
    }
    std::string text(lengths[0], '\0');
    Message message;
    message.bytes.resize(lengths[1]);
    if (!read(std::as_writable_bytes(std::span(text))) || !read(message.bytes)) {
        return std::nullopt;
    }
    message.body = Json::parse(text, nullptr, false);
    return message.body.is_object() ? std::optional(std::move(message)) : std::nullopt;
}

} // namespace hyalite::live
