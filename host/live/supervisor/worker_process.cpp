#include "live/supervisor/worker_process.h"

#include "base/error.h"

#include <array>
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

void check(int error, const char* call) {
    if (error != 0) {
        throw Error(ExitCode::Device,
                    std::string("cannot start a worker: ") + call + ": " + std::generic_category().message(error));
    }
}

class FileDescriptor {
public:
    explicit FileDescriptor(int number) : number_(number) {}
    ~FileDescriptor() { ::close(number_); }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;

    [[nodiscard]] int number() const { return number_; }

    // A copy above the numbers that the worker's files get, so that placing one file overwrites neither.
    [[nodiscard]] static int copyOf(int file) {
        const int copy = ::fcntl(file, F_DUPFD_CLOEXEC, std::max(kChannelFile, kPulseFile) + 1);
        check(copy < 0 ? errno : 0, "fcntl");
        return copy;
    }

private:
    int number_;
};

// The worker inherits two files, beside the standard ones.
class FileActions {
public:
    FileActions() { check(::posix_spawn_file_actions_init(&actions_), "posix_spawn_file_actions_init"); }
    ~FileActions() { ::posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    void place(int file, int number) {
        check(::posix_spawn_file_actions_adddup2(&actions_, file, number), "posix_spawn_file_actions_adddup2");
    }
    [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

// The worker receives all signals but Ctrl-C: the server blocks those that it waits for, and Ctrl-C is for the server.
class SpawnAttributes {
public:
    SpawnAttributes() {
        check(::posix_spawnattr_init(&attributes_), "posix_spawnattr_init");
        sigset_t none;
        ::sigemptyset(&none);
        // These three fail for invalid values only
        ::posix_spawnattr_setsigmask(&attributes_, &none);
        ::posix_spawnattr_setpgroup(&attributes_, 0);
        ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    }
    ~SpawnAttributes() { ::posix_spawnattr_destroy(&attributes_); }
    SpawnAttributes(const SpawnAttributes&) = delete;
    SpawnAttributes& operator=(const SpawnAttributes&) = delete;

    [[nodiscard]] const posix_spawnattr_t* get() const { return &attributes_; }

private:
    posix_spawnattr_t attributes_{};
};

} // namespace

WorkerProcess::WorkerProcess(std::vector<std::string> arguments, const std::string& program) {
    std::array<int, 2> sockets{-1, -1};
    check(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) == 0 ? 0 : errno, "socketpair");
    channel_ = std::make_unique<Channel>(sockets[0]);
    const FileDescriptor workersEnd(sockets[1]);

    arguments.insert(arguments.begin(), "hyalite");
    for (const auto& [option, file] : {std::pair("--channel", kChannelFile), std::pair("--pulse", kPulseFile)}) {
        arguments.emplace_back(option);
        arguments.push_back(std::to_string(file));
    }
    std::vector<char*> argv;
    for (std::string& argument : arguments) {
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);

    const FileDescriptor channel(FileDescriptor::copyOf(workersEnd.number()));
    const FileDescriptor pulse(FileDescriptor::copyOf(pulse_.file()));
    FileActions actions;
    actions.place(channel.number(), kChannelFile);
    actions.place(pulse.number(), kPulseFile);
    const SpawnAttributes attributes;
    check(::posix_spawn(&process_, program.c_str(), actions.get(), attributes.get(), argv.data(), environ),
          "posix_spawn");
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
    const int code = WEXITSTATUS(status);
    if (code == static_cast<int>(ExitCode::Device)) {
        return "ended because the device failed or took longer than --device-timeout";
    }
    return "ended with exit code " + std::to_string(code);
}

} // namespace hyalite::live
