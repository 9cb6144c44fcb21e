// The device shared by all tests of one program. If HYALITE_VALIDATION is set in the environment, validation layers are
// enabled, and any message from them fails the program.
#pragma once

#include "gpu/commands.h"
#include "gpu/shader_compiler.h"

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace hyalite::testing {

class Gpu {
public:
    ~Gpu();
    Gpu(const Gpu&) = delete;
    Gpu& operator=(const Gpu&) = delete;

    // Created on first use; without a usable device, the requesting test fails.
    static Gpu& shared();

    [[nodiscard]] const gpu::Context& context() const { return *context_; }
    // Of the source tree's shaders; its cache is in the build folder.
    [[nodiscard]] const gpu::ShaderCompiler& compiler() const { return compiler_; }
    // All TABLE_* bindings of shaders/shared/scene_records.h.
    [[nodiscard]] gpu::TexelTables& tables() { return *tables_; }
    // Created on first use and kept: compiling the kernel takes most of the time of a small dispatch. Fits any tables
    // that have all the bindings.
    [[nodiscard]] const gpu::Kernel& kernel(const std::string& name, const gpu::Specialization& specialization);

private:
    Gpu();

    std::atomic<unsigned> messages_ = 0; // of the validation layers
    std::unique_ptr<gpu::Context> context_;
    gpu::ShaderCompiler compiler_;
    std::unique_ptr<gpu::TexelTables> tables_;
    std::map<std::pair<std::string, gpu::Specialization>, gpu::Kernel> kernels_;
};

} // namespace hyalite::testing
