// A worker's process starts with its channel and its pulse, or not at all; its end is described.
#include "base/error.h"
#include "live/supervisor/worker_process.h"

#include <catch2/catch_test_macros.hpp>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>

using namespace hyalite;
using namespace hyalite::live;

namespace {

const std::string kShell = "/bin/sh";

std::string endOf(const std::string& script) {
    WorkerProcess worker({"-c", script}, kShell);
    return worker.wait();
}

// Holds every file descriptor that the process may open, and gives some of them back.
class ScarceFiles {
public:
    ScarceFiles() {
        for (int file = open(); file >= 0; file = open()) {
            files_.push_back(file);
        }
    }
    ~ScarceFiles() { giveBack(files_.size()); }
    ScarceFiles(const ScarceFiles&) = delete;
    ScarceFiles& operator=(const ScarceFiles&) = delete;

    void giveBack(std::size_t count) {
        for (; count > 0 && !files_.empty(); --count) {
            ::close(files_.back());
            files_.pop_back();
        }
    }

private:
    static int open() { return ::open("/dev/null", O_RDONLY | O_CLOEXEC); }
    std::vector<int> files_;
};

} // namespace

TEST_CASE("the end of a worker is described in words", "[live]") {
    CHECK(endOf("exit 3") == "ended with exit code 3");
    CHECK(endOf("exit 4") == "ended because the device failed or took longer than --device-timeout");
    CHECK(endOf("kill -SEGV $$") == "crashed (Segmentation fault)");
    WorkerProcess worker({"-c", "while true; do sleep 60; done"}, kShell);
    worker.kill();
    CHECK(worker.wait() == "was stopped");
}

TEST_CASE("a worker inherits its channel and its pulse", "[live]") {
    CHECK(endOf("test -S /proc/self/fd/3 && test -e /proc/self/fd/4") == "ended with exit code 0");
}

TEST_CASE("the pulse's memory is not open in other programs that the server starts", "[live]") {
    const Pulse pulse;
    CHECK((::fcntl(pulse.file(), F_GETFD) & FD_CLOEXEC) != 0);
}

TEST_CASE("a worker that cannot have both its files does not start", "[live]") {
    // Of n file descriptors, some step of the start lacks one, whichever step that is
    for (std::size_t n = 0; n < 10; ++n) {
        CAPTURE(n);
        ScarceFiles files;
        files.giveBack(n);
        std::unique_ptr<WorkerProcess> worker;
        try {
            worker = std::make_unique<WorkerProcess>(
                std::vector<std::string>{"-c", "test -S /proc/self/fd/3 && test -e /proc/self/fd/4"}, kShell);
        } catch (const Error& error) {
            CHECK(error.code() == ExitCode::Device);
            continue;
        }
        CHECK(worker->wait() == "ended with exit code 0");
    }
}

TEST_CASE("a program that does not exist is an error", "[live]") {
    CHECK_THROWS_AS(WorkerProcess({}, "/nonexistent/hyalite"), Error);
}
