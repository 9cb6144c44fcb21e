// What kernels print (shaders/lib/debug.glsl): owns the buffer that they print to, and reads it after each dispatch.
#pragma once

#include "gpu/buffer.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace hyalite::live {

class DebugPrints {
public:
    // Binds the buffer to its table; `tables` must outlive this.
    DebugPrints(const gpu::Context& context, gpu::TexelTables& tables);

    // From the next dispatch on: whether kernels print, and the pixel that debugPixel() is true for (kNone: none).
    void listen(bool on, std::uint32_t pixel);

    // After a dispatch of that kernel: keeps what it printed, sorted by thread and then by line.
    void collect(const std::string& kernel);

    struct Prints {
        std::vector<std::string> lines; // "kernel:line thread 12: 0.5 0.25"
        std::uint64_t lost = 0;         // prints that found no room
    };
    [[nodiscard]] Prints take();

private:
    gpu::Array<std::uint32_t> words_;
    gpu::Array<glm::vec4> address_;
    gpu::TexelTables& tables_;
    bool isOn_ = false;
    Prints prints_;
};

} // namespace hyalite::live
