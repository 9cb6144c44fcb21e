// Messages between server and worker arrive as sent; anything else is an error, never a crash.
#include "base/error.h"
#include "live/messages/page_messages.h"
#include "live/page/page_state.h"
#include "unit/live/socket_pair.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <sys/socket.h>

using namespace hyalite;
using namespace hyalite::live;
using testing::SocketPair;

namespace {

std::string refusalOf(const Json& body) {
    try {
        static_cast<void>(readWorkerMessage({.body = body, .bytes = {}}));
    } catch (const Error& error) {
        CHECK(error.code() == ExitCode::BadInput);
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST_CASE("the server's messages arrive as sent", "[live]") {
    const SocketPair pair;
    send(*pair.server,
         Start{.scene = "/scenes/room.yaml", .versions = {.good = {{"trace", "trace-1"}}, .bad = {"trace-2"}}});
    send(*pair.server, Look{.revision = 7,
                            .settings = {{"render.photons", "5000"}},
                            .shown = "depth",
                            .pixel = 12,
                            .change = std::numeric_limits<std::uint64_t>::max()});
    const auto start = std::get<Start>(readServerMessage(*pair.worker->receive()));
    CHECK(start.scene == "/scenes/room.yaml");
    CHECK(start.versions.good == std::map<std::string, std::string>{{"trace", "trace-1"}});
    CHECK(start.versions.bad == std::set<std::string>{"trace-2"});
    const auto look = std::get<Look>(readServerMessage(*pair.worker->receive()));
    CHECK(look.revision == 7);
    CHECK(look.settings == std::map<std::string, std::string>{{"render.photons", "5000"}});
    CHECK(look.shown == "depth");
    CHECK(look.pixel == 12);
    CHECK(look.change == std::numeric_limits<std::uint64_t>::max());
}

TEST_CASE("a picture arrives with its pixels, its layers and an error that is not a number", "[live]") {
    const SocketPair pair;
    PictureRendered sent;
    sent.info.width = 2;
    sent.info.height = 1;
    sent.info.layers = {"direct"};
    sent.info.stages = {{.name = "trace", .seconds = 0.25, .dispatches = 3}};
    sent.info.error =
        std::numeric_limits<double>::quiet_NaN(); // JSON can only represent it as null: the error is unknown
    sent.info.radius = std::numeric_limits<double>::infinity();
    const std::array<float, 12> pixels{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    const auto bytes = std::as_bytes(std::span(pixels));
    sent.pixels.assign(bytes.begin(), bytes.end());
    send(*pair.worker, sent);
    auto received = std::get<PictureRendered>(readWorkerMessage(*pair.server->receive()));
    CHECK(received.info.layers == std::vector<std::string>{"direct"});
    CHECK(received.info.stages.at(0).dispatches == 3);
    CHECK_FALSE(received.info.error);
    CHECK(std::isnan(received.info.radius));
    const std::optional<Picture> picture = pictureOf(std::move(received));
    REQUIRE(picture);
    REQUIRE(picture->layers.size() == 2);
    CHECK(picture->layers[0].image.pixels[1] == glm::vec3(4, 5, 6));
    CHECK(picture->layers[1].name == "direct");
    CHECK(picture->layers[1].image.pixels[1] == glm::vec3(10, 11, 12));
}

TEST_CASE("a picture whose bytes do not fit its size is dropped", "[live]") {
    PictureRendered rendered;
    rendered.info.width = 2;
    rendered.info.height = 2;
    rendered.pixels.resize(2 * 2 * sizeof(glm::vec3) - 1);
    CHECK_FALSE(pictureOf(rendered));
    rendered.info.width = -2;
    rendered.info.height = -2;
    rendered.pixels.resize(2 * 2 * sizeof(glm::vec3));
    CHECK_FALSE(pictureOf(rendered));
}

TEST_CASE("a malformed message is an error that describes the fault", "[live]") {
    CHECK(refusalOf(Json::object()).find("kind") != std::string::npos);
    CHECK(refusalOf({{"kind", 5}}).find("malformed message") != std::string::npos);
    CHECK(refusalOf({{"kind", "dance"}}).find("unknown kind 'dance'") != std::string::npos);
    CHECK(refusalOf({{"kind", "kernel_compiled"}, {"kernel", "trace"}}).find("version") != std::string::npos);
    CHECK(refusalOf({{"kind", "work_done"}, {"change", "soon"}}).find("malformed message") != std::string::npos);
    CHECK(refusalOf({{"kind", "work_done"}, {"change", 3}}) == "accepted");
}

TEST_CASE("bytes that are not a packet are an error, and a closed channel is not", "[live]") {
    const SocketPair pair;
    SECTION("lengths that no packet has") {
        const std::array<std::uint64_t, 2> lengths{~std::uint64_t{0}, 0};
        REQUIRE(::send(pair.rawWorker, lengths.data(), sizeof(lengths), 0) == sizeof(lengths));
        CHECK_THROWS_AS(pair.server->receive(), Error);
    }
    SECTION("text that is not JSON") {
        const std::array<std::uint64_t, 2> lengths{3, 0};
        REQUIRE(::send(pair.rawWorker, lengths.data(), sizeof(lengths), 0) == sizeof(lengths));
        REQUIRE(::send(pair.rawWorker, "{1}", 3, 0) == 3);
        CHECK_THROWS_AS(pair.server->receive(), Error);
    }
    SECTION("closed") {
        pair.worker->close();
        CHECK_FALSE(pair.server->receive());
    }
}

TEST_CASE("the page's changes are read, and those of the wrong type refused by name", "[live]") {
    const ChangeRequest request =
        readChangeRequest({{"settings", {{"render.photons", "5"}, {"render.seed", nullptr}}}, {"shown", "depth"}});
    CHECK(request.settings.at("render.photons") == "5");
    CHECK_FALSE(request.settings.at("render.seed"));
    CHECK(request.shown == "depth");
    CHECK_FALSE(request.isPixelAlone());
    CHECK(readChangeRequest({{"pixel", 5U}}).isPixelAlone());
    CHECK_FALSE(readChangeRequest({{"pixel", 5U}, {"reset", true}}).isPixelAlone());
    const std::map<std::string, Json> refused{{"settings", {{"settings", 3}}},
                                              {"'settings'", {{"settings", {{"render.photons", 5}}}}},
                                              {"shown", {{"shown", 7}}},
                                              {"pixel", {{"pixel", -1}}},
                                              {"'pixel'", {{"pixel", std::uint64_t{1} << 32U}}},
                                              {"reset", {{"reset", "yes"}}},
                                              {"object", Json::array({1})}};
    for (const auto& [named, json] : refused) {
        CAPTURE(json.dump());
        try {
            static_cast<void>(readChangeRequest(json));
            FAIL("accepted");
        } catch (const Error& error) {
            CHECK(error.code() == ExitCode::WrongUsage);
            CHECK(std::string(error.what()).find(named) != std::string::npos);
        }
    }
}
