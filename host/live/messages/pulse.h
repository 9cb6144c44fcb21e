// What a worker is doing, in memory shared with the server: readable even while a kernel hangs, and after a crash.
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
    Pulse();                    // allocates the memory, behind a file that is closed on exec; throws Error(Device)
    explicit Pulse(int shared); // maps the memory of another process's Pulse; owns the file
    ~Pulse();
    Pulse(const Pulse&) = delete;
    Pulse& operator=(const Pulse&) = delete;

    [[nodiscard]] int file() const { return file_; }

    // For the worker, from one thread: work begins, or has ended.
    void begin(std::string_view work, bool isKernel);
    void end();

    struct Work {
        std::string name; // the kernel's, or e.g. "loading the scene"
        bool isKernel = false;
        double seconds = 0; // so far
    };
    [[nodiscard]] std::optional<Work> look() const; // nothing: the worker waits for messages

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

// Work outside kernels, from construction to destruction.
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
