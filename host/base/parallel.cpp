#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace hyalite {

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t pieces = (count + grain - 1) / grain;
    const std::size_t workers = std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), pieces);
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex failureMutex;

    const auto work = [&] {
        for (std::size_t piece = next++; piece < pieces; piece = next++) {
            try {
                body(piece * grain, std::min(count, (piece + 1) * grain));
            } catch (...) {
                const std::lock_guard lock(failureMutex);
                if (!failure) {
                    failure = std::current_exception();
                }
                next = pieces;
            }
        }
    };

    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < workers; ++i) {
        threads.emplace_back(work);
    }
    work();
    threads.clear(); // joins
    if (failure) {
        std::rethrow_exception(failure);
    }
}

} // namespace hyalite
