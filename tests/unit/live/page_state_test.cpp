// Responses to the page: at once if there is news, else on the next change or after a timeout.
#include "live/page/page_state.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <thread>

using namespace hyalite::live;
using namespace std::chrono_literals;

namespace {

constexpr auto kForever = 60s; // of a test that does not fail

PageState makePage() {
    return PageState("room.yaml", {{"render.photons", "5"}},
                     LiveFiles("/nonexistent/shaders", "/nonexistent/room.yaml"));
}

ChangeRequest viewOf(const std::string& shown) {
    ChangeRequest request;
    request.shown = shown;
    return request;
}

} // namespace

TEST_CASE("a change has a number, and the page is busy until the worker is done with it", "[live]") {
    PageState page = makePage();
    StateAnswer state = page.state(0, 0ms);
    CHECK(state.changes == 1);
    CHECK(state.isBusy);
    page.finished({0}); // a worker that has not received what the page wants
    CHECK(page.state(0, 0ms).isBusy);
    page.finished({1});
    CHECK_FALSE(page.state(0, 0ms).isBusy);
    page.change(viewOf("depth"));
    state = page.state(0, 0ms);
    CHECK(state.shown == "depth");
    CHECK(state.revision == 2);
    CHECK(state.changes == 2);
    CHECK(state.isBusy);
    CHECK(page.filesChanged() == 3);
    page.finished({2});
    CHECK(page.state(0, 0ms).isBusy);
    page.finished({3});
    CHECK_FALSE(page.state(0, 0ms).isBusy);
    // A worker that starts anew has everything before it
    page.workerStarts();
    CHECK(page.state(0, 0ms).isBusy);
    page.setWorkerWanted(false);
    CHECK_FALSE(page.state(0, 0ms).isBusy);
}

TEST_CASE("settings are set, removed and reset to those of the start", "[live]") {
    PageState page = makePage();
    ChangeRequest request;
    request.settings = {{"render.photons", std::nullopt}, {"render.seed", "3"}};
    page.change(request);
    CHECK(page.look().settings == std::map<std::string, std::string>{{"render.seed", "3"}});
    request = {};
    request.reset = true;
    page.change(request);
    CHECK(page.look().settings == std::map<std::string, std::string>{{"render.photons", "5"}});
}

TEST_CASE("a request for the state waits for another version", "[live]") {
    PageState page = makePage();
    const std::uint64_t seen = page.state(0, 0ms).version;
    StateAnswer answer;
    std::thread reader([&] { answer = page.state(seen, kForever); });
    page.addNote("news");
    reader.join();
    CHECK(answer.version > seen);
    CHECK(answer.notes.back() == "news");
}

TEST_CASE("requests beyond the limit do not wait for news", "[live]") {
    PageState page = makePage();
    const std::uint64_t seen = page.state(0, 0ms).version;
    // The requests at the bound wait until the page is closed; those beyond it return, and would block here otherwise
    constexpr int kBeyond = 20;
    std::atomic<int> answered = 0;
    std::vector<std::thread> readers;
    for (int i = 0; i < PageState::kMostWaiting + kBeyond; ++i) {
        readers.emplace_back([&] {
            static_cast<void>(page.state(seen, kForever));
            ++answered;
        });
    }
    const auto end = std::chrono::steady_clock::now() + kForever;
    while (answered < kBeyond && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(1ms);
    }
    CHECK(answered == kBeyond);
    page.close();
    for (std::thread& reader : readers) {
        reader.join();
    }
}

TEST_CASE("only the last request for a path is answered", "[live]") {
    PageState page = makePage();
    const std::uint64_t first = page.beginInspection();
    const std::uint64_t second = page.beginInspection();
    CHECK(page.awaitInspection(first, kForever).error == "another pixel was asked for meanwhile");
    page.answer({.request = first, .error = {}, .path = "of the first"});
    page.answer({.request = second, .error = {}, .path = "of the second"});
    const InspectedPath path = page.awaitInspection(second, kForever);
    CHECK_FALSE(path.error);
    CHECK(path.path == "of the second");
    page.failInspection("too late");
    CHECK_FALSE(page.awaitInspection(second, kForever).error);
    const std::uint64_t third = page.beginInspection();
    page.failInspection("no worker is running");
    CHECK(page.awaitInspection(third, kForever).error == "no worker is running");
}

TEST_CASE("no request waits once the page is closed", "[live]") {
    PageState page = makePage();
    const std::uint64_t seen = page.state(0, 0ms).version;
    const std::uint64_t request = page.beginInspection();
    page.close();
    CHECK(page.state(seen, kForever).isClosing);
    CHECK(page.awaitInspection(request, kForever).error);
}

TEST_CASE("the oldest prints and notes give way to the newest", "[live]") {
    PageState page = makePage();
    for (int i = 0; i < 500; ++i) {
        page.addPrints({std::to_string(i)});
        page.addNote(std::to_string(i));
    }
    const StateAnswer state = page.state(0, 0ms);
    CHECK(state.printCount == 500);
    CHECK(state.prints.size() == 400);
    CHECK(state.prints.back() == "499");
    CHECK(state.notes.size() == 30);
    CHECK(state.notes.front() == "470");
}
