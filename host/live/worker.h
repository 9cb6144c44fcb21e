// The process that renders for `hyalite live`: may hang or crash without taking the page with it.
#pragma once

#include "gpu/context.h"
#include "reference/bsdf/custom_twins.h"

#include <filesystem>

namespace hyalite::live {

struct WorkerOptions {
    int channel = -1; // socket to the server, see protocol in worker.cpp
    int pulse = -1;   // shared memory
    std::filesystem::path shaders;
    std::filesystem::path cache;   // not empty
    std::filesystem::path shipped; // kernels compiled with the program, see gpu::ShaderCompiler
    reference::TwinSources twins;  // of scenes' own GLSL
};

// Renders what the server asks for until it is gone.
void runWorker(const gpu::Context& context, const WorkerOptions& options);

} // namespace hyalite::live
