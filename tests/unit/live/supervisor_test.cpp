// The supervisor with shell scripts as workers: whatever a worker does, the server keeps running.
#include "live/supervisor/supervisor.h"

#include <catch2/catch_test_macros.hpp>
#include <chrono>

using namespace hyalite::live;
using namespace std::chrono_literals;

namespace {

constexpr auto kForever = 60s; // of a test that does not fail

SupervisorOptions scripted(const std::string& script) {
    return {.scene = HYALITE_SOURCE_DIR "/scenes/cornell-caustics.yaml",
            .shaders = HYALITE_SOURCE_DIR "/shaders",
            .program = "/bin/sh",
            .workerArguments = {"-c", script},
            .settings = {},
            .say = [](const std::string&) {}};
}

// The first state that meets the condition, or the last one before the test's timeout.
template <class Condition>
StateAnswer waitFor(Supervisor& supervisor, const Condition& condition) {
    const auto end = std::chrono::steady_clock::now() + kForever;
    StateAnswer state = supervisor.page().state(0, 0ms);
    while (!condition(state) && std::chrono::steady_clock::now() < end) {
        state = supervisor.page().state(state.version, 1s);
    }
    return state;
}

// A packet of this text, as the argument of printf: two lengths of 8 bytes, the second zero, and the text.
std::string packet(const std::string& text) {
    std::string octal; // of a length below 256
    for (const unsigned shift : {6U, 3U, 0U}) {
        octal += static_cast<char>('0' + ((text.size() >> shift) & 7U));
    }
    std::string zeros;
    for (int i = 0; i < 15; ++i) {
        zeros += "\\000";
    }
    return "printf '\\" + octal + zeros + "'; printf '%s' '" + text + "'";
}

} // namespace

TEST_CASE("workers that crash start again, until they have ended too often", "[live]") {
    Supervisor supervisor(scripted("kill -SEGV $$"));
    const StateAnswer state = waitFor(supervisor, [](const StateAnswer& s) { return s.notes.size() >= 3; });
    REQUIRE(state.notes.size() == 3);
    CHECK(state.notes.front() == "the worker crashed (Segmentation fault); a new worker starts");
    CHECK(state.notes.back() ==
          "the worker crashed (Segmentation fault); it has ended too often: change something to try again");
    CHECK_FALSE(waitFor(supervisor, [](const StateAnswer& s) { return !s.isBusy; }).isBusy);
    CHECK(supervisor.inspect({.x = 0, .y = 0}).error);
    ChangeRequest change;
    change.shown = "depth";
    supervisor.change(change);
    CHECK(waitFor(supervisor, [](const StateAnswer& s) { return s.notes.size() >= 6; }).notes.size() == 6);
}

TEST_CASE("a worker that sends an invalid message is stopped, and the server keeps running", "[live]") {
    SECTION("bytes") {
        Supervisor supervisor(scripted("printf AAAAAAAAAAAAAAAA >&3; exec sleep 60"));
        const auto notes = waitFor(supervisor, [](const StateAnswer& s) { return !s.notes.empty(); }).notes;
        REQUIRE_FALSE(notes.empty());
        CHECK(notes.front().starts_with("the worker was stopped: it sent a malformed packet"));
    }
    SECTION("a message without its keys") {
        Supervisor supervisor(scripted("{ " + packet(R"({"kind": "kernel_compiled"})") + "; } >&3; exec sleep 60"));
        const auto notes = waitFor(supervisor, [](const StateAnswer& s) { return !s.notes.empty(); }).notes;
        REQUIRE_FALSE(notes.empty());
        CHECK(notes.front().starts_with("the worker was stopped: it sent a malformed message"));
    }
}

TEST_CASE("messages that a worker sent before its end count", "[live]") {
    // The second end is blamed on the kernel, which had its second chance
    const std::string compiled = packet(R"({"kind": "kernel_compiled", "kernel": "trace", "version": "trace-1"})");
    Supervisor supervisor(scripted("{ " + compiled + "; } >&3; kill -SEGV $$"));
    const StateAnswer state = waitFor(supervisor, [](const StateAnswer& s) { return !s.errors.empty(); });
    REQUIRE(state.errors.size() == 1);
    CHECK(state.errors.front().source == "worker");
    CHECK(state.errors.front().kernel == "trace");
}

TEST_CASE("a program that cannot be started is reported, and the server keeps running", "[live]") {
    SupervisorOptions options = scripted("");
    options.program = "/nonexistent/hyalite";
    Supervisor supervisor(std::move(options));
    const StateAnswer state = waitFor(supervisor, [](const StateAnswer& s) { return !s.notes.empty() && !s.isBusy; });
    REQUIRE_FALSE(state.notes.empty());
    CHECK(state.notes.front().starts_with("cannot start a worker: posix_spawn"));
    CHECK_FALSE(state.isBusy);
}
