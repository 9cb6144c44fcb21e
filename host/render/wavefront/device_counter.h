// A counter of 64 bits on the device, which kernels add to: see shaders/lib/counter.glsl.
#pragma once

#include "gpu/buffer.h"

#include "shaders/shared/path_records.h"

#include <array>

namespace hyalite::render {

class DeviceCounter {
public:
    DeviceCounter(const gpu::Context& context, const std::string& name) : words_(context, 2, name) { set(0); }

    operator shared::UintArray() const { return words_; } // NOLINT(google-explicit-constructor): as an argument

    // No command may be in flight.
    [[nodiscard]] std::uint64_t read() const {
        const std::vector<shared::uint> words = words_.read();
        return std::uint64_t{words[1]} << 32U | words[0];
    }
    void set(std::uint64_t value) const {
        words_.write(std::array{static_cast<shared::uint>(value), static_cast<shared::uint>(value >> 32U)});
    }

private:
    gpu::Array<shared::uint> words_;
};

} // namespace hyalite::render
