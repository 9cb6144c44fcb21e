// A compute pipeline whose interface is read from its SPIR-V.
#pragma once

#include "gpu/buffer.h"
#include "gpu/shader_compiler.h"

#include <map>
#include <string>

namespace hyalite::gpu {

struct StructMember {
    std::string name; // "camera.width" inside a struct member
    std::uint32_t offset = 0;
    std::uint32_t size = 0;
};

// What the SPIR-V says of itself.
struct KernelInterface {
    std::uint32_t pushConstantBytes = 0;
    std::uint32_t localSize = 0;                                  // threads of a workgroup, along x
    std::map<std::string, std::uint32_t> specializationConstants; // name to constant id
    std::map<std::uint32_t, TexelFormat> tables;                  // binding to what the kernel reads there
    std::map<std::string, std::vector<StructMember>> structs;     // every struct in a push constant or device array
    std::map<std::string, std::uint32_t> arrayStrides;            // element struct of a device array to its stride
};

[[nodiscard]] KernelInterface reflect(const SpirV& spirv);

// Values of specialization constants by name; bool as 0 or 1. A name the kernel does not have is ignored, so that one
// description of the scene serves every kernel.
using Specialization = std::map<std::string, std::uint32_t>;

class Kernel {
public:
    Kernel(const Context& context, const TexelTables& tables, const ShaderCompiler& compiler, std::string name,
           const Specialization& specialization = {});
    ~Kernel();
    Kernel(Kernel&&) noexcept;
    Kernel& operator=(Kernel&&) noexcept;

    [[nodiscard]] const std::string& name() const;
    [[nodiscard]] const KernelInterface& interface() const;

    struct Impl;
    [[nodiscard]] const Impl& impl() const { return *impl_; }

private:
    std::unique_ptr<Impl> impl_;
};

} // namespace hyalite::gpu
