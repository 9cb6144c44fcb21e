// Two connected channels in one process.
#pragma once

#include "live/messages/channel.h"

#include <memory>

namespace hyalite::testing {

struct SocketPair {
    SocketPair();

    int rawWorker = -1; // socket of `worker`, for bytes that are not packets
    std::unique_ptr<live::Channel> server;
    std::unique_ptr<live::Channel> worker;
};

} // namespace hyalite::testing
