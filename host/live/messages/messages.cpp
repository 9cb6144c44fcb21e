#include "live/messages/messages.h"

#include <concepts>
#include <utility>

namespace hyalite::live {

namespace {

// The alternative of the variant that the packet's kind names.
template <class Variant, std::size_t index = 0>
Variant read(Packet& packet, const std::string& kind) {
    if constexpr (index == std::variant_size_v<Variant>) {
        throw Error(ExitCode::BadInput, "malformed message: unknown kind '" + kind + "'");
    } else {
        using Message = std::variant_alternative_t<index, Variant>;
        if (kind != Message::kKind) {
            return read<Variant, index + 1>(packet, kind);
        }
        Message message = packet.body.get<Message>();
        if constexpr (requires { message.pixels; }) {
            message.pixels = std::move(packet.bytes);
        }
        return message;
    }
}

template <class Variant>
Variant readAny(Packet packet) {
    try {
        return read<Variant>(packet, packet.body.at("kind").template get<std::string>());
    } catch (const Json::exception& error) {
        throw Error(ExitCode::BadInput, std::string("malformed message: ") + error.what());
    }
}

} // namespace

ServerMessage readServerMessage(Packet packet) {
    return readAny<ServerMessage>(std::move(packet));
}

WorkerMessage readWorkerMessage(Packet packet) {
    return readAny<WorkerMessage>(std::move(packet));
}

} // namespace hyalite::live
