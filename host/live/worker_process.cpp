#include "live/worker_process.h"

#include "base/error.h"

#include <cerrno>
#include <csignal>
#include <cstring> // sigdescr_np
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

extern char** environ; // NOLINT(readability-redundant-declaration): POSIX has it declared by its user

namespace hyalite::live {

namespace {

constexpr int kChannelFile = 3; // in the worker
constexpr int kPulseFile = 4;

} // namespace

WorkerProcess::WorkerProcess(std::vector<std::string> arguments) {
    const auto check = [](int error, const char* what) {
        if (error != 0) {
            throw Error(ExitCode::Device,
                        std::string("cannot start a worker: ") + what + ": " + std::generic_category().message(error));
        }
    };
    int sockets[2] = {-1, -1};
    check(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) == 0 ? 0 : errno, "socketpair");
    channel_ = std::make_unique<Channel>(sockets[0]);

    for (const std::string& option :
         {std::string("--channel"), std::to_string(kChannelFile), std::string("--pulse"), std::to_string(kPulseFile)}) {
        arguments.push_back(option);
    }
    std::vector<char*> argv;
    std::string name = "hyalite";
    argv.push_back(name.data());
    for (std::string& argument : arguments) {
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);

    // Through high numbers, so that neither is overwritten before it is moved
    const int channel = ::fcntl(sockets[1], F_DUPFD_CLOEXEC, 64);
    const int pulse = ::fcntl(pulse_.file(), F_DUPFD_CLOEXEC, 64);
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, channel, kChannelFile);
    ::posix_spawn_file_actions_adddup2(&actions, pulse, kPulseFile);
    // The server blocks signals that it waits for
    ::posix_spawnattr_init(&attributes);
    sigset_t none;
    ::sigemptyset(&none);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setpgroup(&attributes, 0); // Ctrl-C is the server's
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    const int error = ::posix_spawn(&process_, "/proc/self/exe", &actions, &attributes, argv.data(), environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(channel);
    ::close(pulse);
    ::close(sockets[1]);
    check(error, "posix_spawn");
}

WorkerProcess::~WorkerProcess() {
    if (!isReaped_) {
        kill();
        static_cast<void>(wait());
    }
}

void WorkerProcess::kill() {
    isKilled_ = true;
    if (!isReaped_) {
        ::kill(process_, SIGKILL);
    }
}

std::string WorkerProcess::wait() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    isReaped_ = true;
    if (isKilled_) {
        return "was stopped";
    }
    if (WIFSIGNALED(status)) {
        return std::string("crashed (") + ::sigdescr_np(WTERMSIG(status)) + ")";
    }
    return "ended with exit code " + std::to_string(WEXITSTATUS(status));
}

} // namespace hyalite::live
