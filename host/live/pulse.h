// What a worker is at, in memory that the server sees too: readable while a kernel runs for ever, and when it has
// crashed.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace hyalite::live {

class Pulse {
public:
    Pulse();                    // new memory
    explicit Pulse(int shared); // that of the process that made it; owns the file
    ~Pulse();
    Pulse(const Pulse&) = delete;
    Pulse& operator=(const Pulse&) = delete;

    [[nodiscard]] int file() const { return file_; }

    // The worker's side, from one thread: work goes on, or has ended.
    void begin(std::string_view work, bool isKernel);
    void end();

    struct Work {
        std::string name; // of the kernel, or e.g. "loading the scene"
        bool isKernel = false;
        double seconds = 0; // so far
    };
    [[nodiscard]] std::optional<Work> look() const; // nothing: it waits

private:
    struct Shared {
        std::atomic<std::uint64_t> since; // [ns] of the steady clock, which all processes share; 0: no work
        std::atomic<std::uint32_t> isKernel;
        std::array<std::atomic<char>, 60> name;
    };
    static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

    void map();

    int file_;
    Shared* shared_ = nullptr;
};

// Work that is not a kernel's, as long as it exists.
class Activity {
public:
    Activity(Pulse& pulse, std::string_view work) : pulse_(pulse) { pulse_.begin(work, false); }
    ~Activity() { pulse_.end(); }
    Activity(const Activity&) = delete;
    Activity& operator=(const Activity&) = delete;

private:
    Pulse& pulse_;
};

} // namespace hyalite::live
