// What a Kernel holds.
#pragma once

#include "gpu/context_impl.h"
#include "gpu/kernel.h"

namespace hyalite::gpu {

struct Kernel::Impl {
    std::string name;
    KernelInterface interface;
    vk::raii::PipelineLayout layout = nullptr;
    vk::raii::Pipeline pipeline = nullptr;
};

} // namespace hyalite::gpu
