#include "unit/live/socket_pair.h"

#include <array>
#include <stdexcept>
#include <sys/socket.h>

namespace hyalite::testing {

SocketPair::SocketPair() {
    std::array<int, 2> sockets{-1, -1};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) {
        throw std::runtime_error("no sockets");
    }
    rawWorker = sockets[1];
    server = std::make_unique<live::Channel>(sockets[0]);
    worker = std::make_unique<live::Channel>(sockets[1]);
}

} // namespace hyalite::testing
