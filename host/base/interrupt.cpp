#include "base/interrupt.h"

#include <array>
#include <csignal>

namespace hyalite {

namespace {

constexpr std::array<int, 2> kSignals{SIGINT, SIGTERM};

// A signal handler may touch nothing else.
volatile std::sig_atomic_t noted = 0;

extern "C" void note(int number) {
    noted = number;
    for (const int each : kSignals) {
        std::signal(each, SIG_DFL); // the next one ends the program
    }
}

} // namespace

InterruptWatch::InterruptWatch() {
    noted = 0;
    struct ::sigaction action{};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART; // interrupted reads, writes and waits continue
    for (const int each : kSignals) {
        ::sigaction(each, &action, nullptr);
    }
}

InterruptWatch::~InterruptWatch() {
    for (const int each : kSignals) {
        std::signal(each, SIG_DFL);
    }
}

const char* InterruptWatch::signal() {
    return noted == 0 ? nullptr : noted == SIGINT ? "SIGINT" : "SIGTERM";
}

} // namespace hyalite
