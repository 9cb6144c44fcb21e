// A worker as its server holds it: started, spoken to, looked at, stopped.
#pragma once

#include "live/channel.h"
#include "live/pulse.h"

#include <string>
#include <sys/types.h>
#include <vector>

namespace hyalite::live {

class WorkerProcess {
public:
    // Runs this program anew with `arguments`, --channel and --pulse. Throws Error(Device).
    explicit WorkerProcess(std::vector<std::string> arguments);
    ~WorkerProcess(); // stops it
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;

    [[nodiscard]] Channel& channel() { return *channel_; }
    [[nodiscard]] const Pulse& pulse() const { return pulse_; }

    // At once, whatever it does.
    void kill();
    // Waits until it has ended; how: "crashed (Segmentation fault)", "was stopped", "ended with exit code 4".
    [[nodiscard]] std::string wait();

private:
    Pulse pulse_;
    std::unique_ptr<Channel> channel_;
    pid_t process_ = -1;
    bool isKilled_ = false;
    bool isReaped_ = false;
};

} // namespace hyalite::live
