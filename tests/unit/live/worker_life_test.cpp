// Which kernel is blamed when a worker ends, and whether another worker starts.
#include "live/supervisor/worker_life.h"

#include <catch2/catch_test_macros.hpp>

using namespace hyalite::live;

namespace {

constexpr double kLimit = 10; // [s]

std::optional<Pulse::Work> running(const std::string& kernel, double seconds = 1) {
    return Pulse::Work{.name = kernel, .isKernel = true, .seconds = seconds};
}

WorkerLife::End crashIn(const std::string& kernel) {
    return {.how = "crashed (Segmentation fault)", .work = running(kernel)};
}

// A life in which `trace-1` has proved good.
WorkerLife provedLife() {
    WorkerLife life(kLimit, "/shaders");
    life.workerStarts();
    life.kernelCompiled({.kernel = "trace", .version = "trace-1"});
    life.kernelsProved({{{"trace", "trace-1"}}});
    life.pictureArrives();
    return life;
}

} // namespace

TEST_CASE("a kernel is overdue after the limit, other work after twenty times as long", "[live]") {
    const WorkerLife life(kLimit, "/shaders");
    CHECK_FALSE(life.isOverdue(std::nullopt));
    CHECK_FALSE(life.isOverdue(running("trace", kLimit)));
    CHECK(life.isOverdue(running("trace", kLimit + 0.001)));
    Pulse::Work loading{.name = "loading the scene", .isKernel = false, .seconds = 20 * kLimit};
    CHECK_FALSE(life.isOverdue(loading));
    loading.seconds += 0.001;
    CHECK(life.isOverdue(loading));
}

TEST_CASE("a new version of a kernel that crashes is bad, and the last good one runs instead", "[live]") {
    WorkerLife life = provedLife();
    life.kernelCompiled({.kernel = "trace", .version = "trace-2"});
    const std::string line = life.workerEnds(crashIn("trace"));
    CHECK(line == "kernel 'trace' crashed (Segmentation fault); a new worker starts");
    CHECK(life.versions().bad == std::set<std::string>{"trace-2"});
    REQUIRE(life.stops().size() == 1);
    const ErrorReport stop = life.stops().front();
    CHECK(stop.source == "worker");
    CHECK(stop.kernel == "trace");
    CHECK(stop.file == "/shaders/kernels/trace.comp");
    CHECK(stop.message == "kernel 'trace' crashed (Segmentation fault); its last good version runs instead");
    CHECK(life.wantsWorker());
    // It stands until another version than the last good one runs
    life.standInsAre({"trace"});
    CHECK(life.stops().size() == 1);
    life.standInsAre({});
    CHECK(life.stops().empty());
}

TEST_CASE("a crash in a kernel that proved good is blamed on the versions that have not", "[live]") {
    WorkerLife life = provedLife();
    life.kernelCompiled({.kernel = "shade", .version = "shade-1"});
    life.kernelsProved({{{"trace", "trace-1"}, {"shade", "shade-1"}}});
    life.kernelCompiled({.kernel = "shade", .version = "shade-2"}); // writes where `trace` reads
    static_cast<void>(life.workerEnds(crashIn("trace")));
    CHECK(life.versions().bad == std::set<std::string>{"shade-2"});
}

TEST_CASE("a kernel without an earlier version gets a second chance", "[live]") {
    WorkerLife life(kLimit, "/shaders");
    for (int attempt = 0; attempt < 2; ++attempt) {
        CHECK(life.versions().bad.empty());
        life.workerStarts();
        life.kernelCompiled({.kernel = "trace", .version = "trace-1"});
        static_cast<void>(life.workerEnds({.how = "was stopped", .work = running("trace", 11), .isOverdue = true}));
    }
    CHECK(life.versions().bad == std::set<std::string>{"trace-1"});
    CHECK(life.stops().front().message ==
          "kernel 'trace' did not end within 10 s and was stopped; there is no earlier version to run instead");
}

TEST_CASE("after three workers without a picture no worker starts until something changes", "[live]") {
    WorkerLife life(kLimit, "/shaders");
    const WorkerLife::End end{.how = "ended with exit code 3", .work = {}};
    for (int worker = 0; worker < 2; ++worker) {
        life.workerStarts();
        CHECK(life.workerEnds(end) == "the worker ended with exit code 3; a new worker starts");
        CHECK(life.wantsWorker());
    }
    life.workerStarts();
    CHECK(life.workerEnds(end) ==
          "the worker ended with exit code 3; it has ended too often: change something to try again");
    CHECK_FALSE(life.wantsWorker());
    life.somethingChanges();
    CHECK(life.wantsWorker());
    // A picture makes up for the failures before it
    life.workerStarts();
    static_cast<void>(life.workerEnds(end));
    life.workerStarts();
    static_cast<void>(life.workerEnds(end));
    life.workerStarts();
    life.pictureArrives();
    static_cast<void>(life.workerEnds(end));
    CHECK(life.wantsWorker());
}

TEST_CASE("no worker starts again after one could not be started at all", "[live]") {
    WorkerLife life(kLimit, "/shaders");
    life.startFails();
    CHECK_FALSE(life.wantsWorker());
    life.somethingChanges();
    CHECK(life.wantsWorker());
}
