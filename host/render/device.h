// The device as every stage of a renderer sees it: where kernels come from, where their tables are bound, and the one
// list of commands they are run by.
#pragma once

#include "gpu/commands.h"
#include "gpu/shader_compiler.h"

#include "shaders/shared/scene_records.h"

namespace hyalite::render {

struct Device {
    const gpu::Context& context;
    const gpu::ShaderCompiler& compiler;
    gpu::TexelTables tables{context, TABLE_COUNT};
    gpu::Commands commands;

    Device(const gpu::Context& c, const gpu::ShaderCompiler& s, bool timed)
        : context(c), compiler(s), commands(c, tables, timed) {}

    [[nodiscard]] gpu::Kernel kernel(const std::string& name, const gpu::Specialization& specialization = {}) const {
        return {context, tables, compiler, name, specialization};
    }
};

} // namespace hyalite::render
