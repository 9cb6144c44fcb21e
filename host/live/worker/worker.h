// The process that renders for `hyalite live`: it may hang or crash without taking the page with it.
#pragma once

#include "gpu/context.h"
#include "reference/bsdf/custom_twins.h"

#include <filesystem>

namespace hyalite::live {

struct WorkerOptions {
    int channel = -1; // inherited socket to the server
    int pulse = -1;   // inherited shared memory
    std::filesystem::path shaders;
    std::filesystem::path cache;   // of compiled kernels; not empty
    std::filesystem::path shipped; // kernels compiled with the program, see gpu::ShaderCompiler
    reference::TwinSources twins;  // of scenes' own GLSL
};

// Renders what the server asks for, until the server is gone: then the process ends. Throws Error(BadInput) when the
// first message is not Start.
void runWorker(const gpu::Context& context, const WorkerOptions& options);

} // namespace hyalite::live
