// What the worker tells the server. Nothing is sent twice in a row unchanged.
#pragma once

#include "live/messages/messages.h"
#include "live/worker/live_renderer.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace hyalite::live {

// Errors that keep the picture from being what was asked for.
struct StandingErrors {
    std::optional<Error> scene;   // the scene file does not load
    std::optional<Error> setting; // a setting of the page is refused
    std::optional<Error> run;     // a pass failed
};

class WorkerReports {
public:
    // References are kept.
    WorkerReports(Channel& channel, const ReloadingCompiler& compiler) : channel_(channel), compiler_(compiler) {}

    void done(std::uint64_t change);
    void proved(const KernelVersions& versions);
    void errors(const StandingErrors& standing);
    void prints(DebugPrints::Prints prints);
    void scene(const LiveRenderer& renderer);
    void files(std::map<std::string, FileStamp> files);
    void path(InspectedPath path);

    // The first picture of its size always, others unless the last was sent a moment ago: reading a picture back takes
    // time too.
    void pictureOfPass(LiveRenderer& renderer, std::uint32_t revision);

private:
    using Clock = std::chrono::steady_clock;

    Channel& channel_;
    const ReloadingCompiler& compiler_;
    std::optional<std::uint64_t> doneAfter_;
    std::map<std::string, std::string> sentGood_;
    Json sentErrors_;
    std::map<std::string, FileStamp> sentFiles_;
    Clock::time_point pictureAt_;
    bool isFirstOfSize_ = true; // the next picture is the first of its size
};

} // namespace hyalite::live
