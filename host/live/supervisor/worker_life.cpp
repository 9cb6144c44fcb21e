#include "live/supervisor/worker_life.h"

namespace hyalite::live {

namespace {

constexpr int kMostFailures = 3;
constexpr int kStrikes = 2; // after which a version without a good one to fall back on counts as bad
// Work outside kernels may take this many times as long: loading a scene, or compiling a kernel in the driver.
constexpr double kPatienceOutsideKernels = 20;

} // namespace

std::vector<ErrorReport> WorkerLife::stops() const {
    std::vector<ErrorReport> reports;
    for (const auto& [kernel, report] : stops_) {
        reports.push_back(report);
    }
    return reports;
}

bool WorkerLife::isOverdue(const std::optional<Pulse::Work>& work) const {
    return work && work->seconds > limit_ * (work->isKernel ? 1 : kPatienceOutsideKernels);
}

void WorkerLife::standInsAre(const std::set<std::string>& kernels) {
    std::erase_if(
        stops_, [&](const auto& stop) { return versions_.good.contains(stop.first) && !kernels.contains(stop.first); });
}

void WorkerLife::somethingChanges() {
    failures_ = 0;
    wantsWorker_ = true;
}

std::string WorkerLife::describe(const End& end) const {
    const bool inKernel = end.work && end.work->isKernel;
    const std::string who = inKernel ? "kernel '" + end.work->name + "' " : "the worker ";
    if (!end.isOverdue) {
        return who + end.how;
    }
    if (inKernel) {
        return who + "did not end within " + std::to_string(static_cast<int>(limit_)) + " s and was stopped";
    }
    return who + "was stopped: " + end.work->name + " took too long";
}

bool WorkerLife::hasProved(const std::string& kernel, const std::string& version) const {
    const auto good = versions_.good.find(kernel);
    return good != versions_.good.end() && good->second == version;
}

std::set<std::string> WorkerLife::blamedFor(const End& end) {
    // The kernel that ran, or, if that one had proved good, every version that had not
    std::set<std::string> blamed;
    for (const auto& [kernel, version] : running_) {
        if (!hasProved(kernel, version)) {
            blamed.insert(kernel);
        }
    }
    if (end.work && end.work->isKernel && blamed.contains(end.work->name)) {
        blamed = {end.work->name};
    }
    // Drivers hang too, if rarely: a kernel without an earlier version to fall back on gets a second chance
    std::erase_if(blamed, [&](const std::string& kernel) {
        return !versions_.good.contains(kernel) && ++strikes_[running_.at(kernel)] < kStrikes;
    });
    return blamed;
}

std::string WorkerLife::workerEnds(const End& end) {
    const std::string line = describe(end);
    const bool inKernel = end.work && end.work->isKernel;
    const std::set<std::string> blamed = blamedFor(end);
    for (const std::string& kernel : blamed) {
        versions_.bad.insert(running_.at(kernel));
        ErrorReport& report = stops_[kernel];
        report = {};
        report.source = "worker";
        report.message = line;
        if (inKernel) {
            report.message += versions_.good.contains(kernel) ? "; its last good version runs instead"
                                                              : "; there is no earlier version to run instead";
        }
        report.hint = "correct the kernel and save it";
        report.kernel = kernel;
        report.file = (shaders_ / "kernels" / (kernel + ".comp")).string();
    }
    failures_ = blamed.empty() ? failures_ + 1 : 0;
    wantsWorker_ = failures_ < kMostFailures;
    return line + (wantsWorker_ ? "; a new worker starts" : "; it has ended too often: change something to try again");
}

} // namespace hyalite::live
