#include "bench/timing.h"

#include <chrono>
#include <sys/resource.h>

namespace hyalite::bench {

namespace {

double secondsOf(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

Run now() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return {std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(),
            secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime)};
}

} // namespace

RunClock::RunClock() : start_(now()) {}

Run RunClock::elapsed() const {
    const Run end = now();
    return {end.seconds - start_.seconds, end.cores - start_.cores};
}

} // namespace hyalite::bench
