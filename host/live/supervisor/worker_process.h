// The worker's process, seen from the server: starts it, talks to it, watches it, kills it.
#pragma once

#include "live/messages/channel.h"
#include "live/messages/pulse.h"

#include <memory>
#include <string>
#include <sys/types.h>
#include <vector>

namespace hyalite::live {

class WorkerProcess {
public:
    // Runs the program with `arguments` followed by --channel and --pulse, which name the files it inherits. Throws
    // Error(Device) when the process cannot be started with both.
    explicit WorkerProcess(std::vector<std::string> arguments, const std::string& program = "/proc/self/exe");
    ~WorkerProcess(); // kills it
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;

    [[nodiscard]] Channel& channel() { return *channel_; }
    [[nodiscard]] const Pulse& pulse() const { return pulse_; }

    // Ends the process at once, whatever it does.
    void kill();
    // Waits for its end, and says how it ended: "crashed (Segmentation fault)", "was stopped", "ended with exit code
    // 3".
    [[nodiscard]] std::string wait();

private:
    Pulse pulse_;
    std::unique_ptr<Channel> channel_;
    pid_t process_ = -1;
    bool isKilled_ = false;
    bool isReaped_ = false;
};

} // namespace hyalite::live
