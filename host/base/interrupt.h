// SIGINT and SIGTERM as requests to stop: the first is recorded, the second ends the program at once.
#pragma once

namespace hyalite {

// One at a time.
class InterruptWatch {
public:
    InterruptWatch();
    ~InterruptWatch(); // the signals end the program again
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    // "SIGINT" or "SIGTERM" once one has come; else nullptr.
    [[nodiscard]] static const char* signal();
};

} // namespace hyalite
