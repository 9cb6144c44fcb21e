// The life of workers as a state machine without threads: which versions of kernels they run, which have proved good,
// which one is blamed when a worker hangs or crashes, and whether another worker is started.
#pragma once

#include "live/messages/messages.h"
#include "live/messages/pulse.h"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace hyalite::live {

class WorkerLife {
public:
    // `limit`: a kernel that takes longer for one piece of its threads is stopped [s]. `shaders`: the folder that
    // errors point to.
    WorkerLife(double limit, std::filesystem::path shaders) : limit_(limit), shaders_(std::move(shaders)) {}

    // Whether a worker should run. Not after several in a row have ended without a picture, until something changes.
    [[nodiscard]] bool wantsWorker() const { return wantsWorker_; }
    [[nodiscard]] const KernelVersions& versions() const { return versions_; }
    // What is said of kernels that brought workers down, until a version that works replaces them.
    [[nodiscard]] std::vector<ErrorReport> stops() const;

    // Whether the worker has to be stopped: it hangs.
    [[nodiscard]] bool isOverdue(const std::optional<Pulse::Work>& work) const;

    // ---- what happens ----

    void workerStarts() { running_.clear(); }
    void kernelCompiled(const KernelCompiled& compiled) { running_[compiled.kernel] = compiled.version; }
    void kernelsProved(KernelsProved proved) { versions_.good = std::move(proved.good); }
    // What was stopped is of interest as long as another version stands in for it.
    void standInsAre(const std::set<std::string>& kernels);
    void pictureArrives() { failures_ = 0; }
    // Files, settings or the view: a reason to try again.
    void somethingChanges();
    // No worker can be started at all.
    void startFails() { wantsWorker_ = false; }

    struct End {
        std::string how;                 // "crashed (Segmentation fault)", see WorkerProcess::wait
        std::optional<Pulse::Work> work; // what it was doing
        bool isOverdue = false;          // and was stopped for it
    };
    // Returns a line that says what happened and what happens next.
    std::string workerEnds(const End& end);

private:
    [[nodiscard]] std::string describe(const End& end) const;
    // The kernels whose running versions are to blame.
    [[nodiscard]] std::set<std::string> blamedFor(const End& end);
    [[nodiscard]] bool hasProved(const std::string& kernel, const std::string& version) const;

    double limit_;
    std::filesystem::path shaders_;
    bool wantsWorker_ = true;
    int failures_ = 0; // workers in a row that ended without a picture and without a kernel to blame
    KernelVersions versions_;
    std::map<std::string, std::string> running_; // by kernel: the version that the worker runs
    std::map<std::string, int> strikes_;         // by version: how often it was to blame
    std::map<std::string, ErrorReport> stops_;   // by kernel
};

} // namespace hyalite::live
