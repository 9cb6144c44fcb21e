#include "live/messages/pulse.h"

#include "base/error.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <sys/mman.h>
#include <system_error>
#include <unistd.h>

namespace hyalite::live {

namespace {

std::uint64_t now() {
    return static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
            .count());
}

} // namespace

Pulse::Pulse() : file_(::memfd_create("hyalite pulse", MFD_CLOEXEC)) {
    if (file_ < 0 || ::ftruncate(file_, sizeof(Shared)) != 0) {
        throw Error(ExitCode::Device, std::string("cannot allocate memory shared with a worker: ") +
                                          std::generic_category().message(errno));
    }
    map();
}

Pulse::Pulse(int shared) : file_(shared) {
    map();
}

void Pulse::map() {
    void* memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
    if (memory == MAP_FAILED) {
        throw Error(ExitCode::Device,
                    std::string("cannot map shared memory: ") + std::generic_category().message(errno));
    }
    shared_ = static_cast<Shared*>(memory); // zeros: no work
}

Pulse::~Pulse() {
    ::munmap(shared_, sizeof(Shared));
    ::close(file_);
}

void Pulse::begin(std::string_view work, bool isKernel) {
    shared_->since = 0;
    for (std::size_t i = 0; i + 1 < shared_->name.size(); ++i) {
        shared_->name.at(i) = i < work.size() ? work[i] : '\0';
    }
    shared_->isKernel = isKernel ? 1 : 0;
    shared_->since = now();
}

void Pulse::end() {
    shared_->since = 0;
}

std::optional<Pulse::Work> Pulse::look() const {
    const std::uint64_t since = shared_->since;
    if (since == 0) {
        return std::nullopt;
    }
    Work work{.name = {}, .isKernel = shared_->isKernel != 0, .seconds = static_cast<double>(now() - since) * 1e-9};
    for (const std::atomic<char>& letter : shared_->name) {
        if (letter == '\0') {
            break;
        }
        work.name += letter;
    }
    return work;
}

} // namespace hyalite::live
