// The contents of a Kernel.
#pragma once

#include "gpu/context_impl.h"
#include "gpu/kernel.h"

namespace hyalite::gpu {

struct Kernel::Impl {
    std::string name;
    KernelInterface interface;
    std::vector<std::string> sources; // in the checked build: see KernelCompiler::sourceFiles
    vk::raii::PipelineLayout layout = nullptr;
    vk::raii::Pipeline pipeline = nullptr;
};

} // namespace hyalite::gpu
