// A packet is two lengths of 8 bytes, the JSON as text, and the bytes.
#include "live/messages/channel.h"

#include "base/error.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <sys/socket.h>
#include <unistd.h>

namespace hyalite::live {

namespace {

// Enough for a picture of 2^24 pixels in all its layers.
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
    // Text that was read from files may not be UTF-8
    const std::string text = body.dump(-1, ' ', false, Json::error_handler_t::replace);
    const std::array<std::uint64_t, 2> lengths{text.size(), bytes.size()};
    const std::scoped_lock lock(sending_);
    return write(std::as_bytes(std::span(lengths))) && write(std::as_bytes(std::span(text))) && write(bytes);
}

std::optional<Packet> Channel::receive() {
    std::array<std::uint64_t, 2> lengths{};
    if (!read(std::as_writable_bytes(std::span(lengths)))) {
        return std::nullopt;
    }
    if (lengths[0] > kLongest || lengths[1] > kLongest) {
        throw Error(ExitCode::BadInput, "malformed packet: it claims to be " + std::to_string(lengths[0]) + " + " +
                                            std::to_string(lengths[1]) + " bytes long");
    }
    std::string text(lengths[0], '\0');
    Packet packet;
    packet.bytes.resize(lengths[1]);
    if (!read(std::as_writable_bytes(std::span(text))) || !read(packet.bytes)) {
        return std::nullopt;
    }
    packet.body = Json::parse(text, nullptr, false);
    if (!packet.body.is_object()) {
        throw Error(ExitCode::BadInput, "malformed packet: its text is not a JSON object");
    }
    return packet;
}

} // namespace hyalite::live
