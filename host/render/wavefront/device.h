// The device as every stage of a renderer sees it: where kernels come from, where their tables are bound, and the one
// command list that runs them.
#pragma once

#include "base/error.h"
#include "gpu/commands.h"
#include "gpu/kernel_compiler.h"

#include "shaders/shared/scene_records.h"

#include <map>
#include <set>
#include <utility>

namespace hyalite::render {

struct Device {
    const gpu::Context& context;
    const gpu::KernelCompiler& compiler;
    gpu::TexelTables tables{context, TABLE_COUNT};
    gpu::Commands commands;

    Device(const gpu::Context& c, const gpu::KernelCompiler& s, bool timed)
        : context(c), compiler(s), commands(c, tables, timed) {}

    // Several stages may request the same kernel: it is built once, in the background. Errors in its source are thrown
    // where it is first run.
    [[nodiscard]] gpu::Kernel kernel(const std::string& name, const gpu::Specialization& specialization = {}) const {
        const auto found = kernels_.find({name, specialization});
        if (found != kernels_.end()) {
            return found->second;
        }
        return kernels_
            .try_emplace({name, specialization},
                         gpu::Kernel::inBackground(context, tables, compiler, name, specialization))
            .first->second;
    }

    // Waits until all kernels are built or have failed.
    void finishKernels() const {
        for (const auto& [key, kernel] : kernels_) {
            try {
                static_cast<void>(kernel.impl());
            } catch (const Error&) {
                continue; // thrown again where the kernel is run
            }
        }
    }

    // Rebuilds these kernels on next request; handles already held stay valid.
    void forget(const std::set<std::string>& names) {
        std::erase_if(kernels_, [&](const auto& entry) { return names.contains(entry.first.first); });
    }

private:
    mutable std::map<std::pair<std::string, gpu::Specialization>, gpu::Kernel> kernels_;
};

} // namespace hyalite::render
