// The worker's inbox: which messages make the current pass obsolete, and how the inbox ends.
#include "live/worker/inbox.h"
#include "unit/live/socket_pair.h"

#include <catch2/catch_test_macros.hpp>

using namespace hyalite;
using namespace hyalite::live;
using testing::SocketPair;

TEST_CASE("a change of the picture makes the current pass obsolete, a click does not", "[live]") {
    const SocketPair pair;
    Inbox inbox(*pair.worker);
    send(*pair.server, InspectPixel{.request = 1, .x = 2, .y = 3});
    send(*pair.server, PixelChosen{.pixel = 5, .restarts = false, .change = 1});
    CHECK(std::get<InspectPixel>(*inbox.take(/*wait*/ true)).x == 2);
    CHECK(std::get<PixelChosen>(*inbox.take(/*wait*/ true)).pixel == 5);
    CHECK_FALSE(inbox.isUnwanted());
    send(*pair.server, SceneChanged{2});
    CHECK(std::get<SceneChanged>(*inbox.take(/*wait*/ true)).change == 2);
    CHECK(inbox.isUnwanted());
    // Once all messages are taken, the next pass is wanted
    CHECK_FALSE(inbox.take(/*wait*/ false));
    CHECK_FALSE(inbox.isUnwanted());
}

TEST_CASE("an inbox that is destroyed closes the channel and takes its thread with it", "[live]") {
    const SocketPair pair;
    {
        const Inbox inbox(*pair.worker);
    }
    // The thread must not end the process, as it does when the server has exited: a thread left running would show here
    CHECK_FALSE(pair.server->receive());
    CHECK_FALSE(pair.worker->receive());
}
