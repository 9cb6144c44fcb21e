// A compute pipeline; its interface is read from its SPIR-V.
#pragma once

#include "gpu/buffer.h"
#include "gpu/kernel_compiler.h"

#include <future>
#include <map>
#include <memory>
#include <string>

namespace hyalite::gpu {

struct StructMember {
    std::string name; // "camera.width" inside a struct member
    std::uint32_t offset = 0;
    std::uint32_t size = 0;
    std::string type = {}; // GLSL's, e.g. "vec3"; for a device array its elements' type, e.g. "Ray"
    bool isArray = false;  // a device array: the member holds its address
};

// A kernel's interface, as its SPIR-V declares it.
struct KernelInterface {
    std::uint32_t pushConstantBytes = 0;
    std::uint32_t localSize = 0;                                  // threads of a workgroup, along x
    std::map<std::string, std::uint32_t> specializationConstants; // name to constant id
    std::map<std::uint32_t, TexelFormat> tables;                  // binding to the format that the kernel reads
    std::map<std::string, std::vector<StructMember>> structs;     // every struct in a push constant or device array
    std::map<std::string, std::uint32_t> arrayStrides;            // element struct of a device array to its stride
};

[[nodiscard]] KernelInterface reflect(const SpirV& spirv);

// Values of specialization constants by name; bool as 0 or 1. Names that the kernel does not have are ignored, so one
// description of the scene serves every kernel.
using Specialization = std::map<std::string, std::uint32_t>;

// Copies share the same pipeline.
class Kernel {
public:
    Kernel(const Context& context, const TexelTables& tables, const KernelCompiler& compiler, const std::string& name,
           const Specialization& specialization = {});

    // The same, built on another thread while the caller continues: its errors are thrown at first use. The arguments
    // must outlive the kernel and its copies.
    [[nodiscard]] static Kernel inBackground(const Context& context, const TexelTables& tables,
                                             const KernelCompiler& compiler, std::string name,
                                             const Specialization& specialization = {});

    // These wait until the kernel is built.
    [[nodiscard]] const std::string& name() const;
    [[nodiscard]] const KernelInterface& interface() const;

    struct Impl;
    [[nodiscard]] const Impl& impl() const { return *impl_.get(); }

private:
    using Made = std::shared_ptr<const Impl>;
    explicit Kernel(std::shared_future<Made> impl) : impl_(std::move(impl)) {}

    std::shared_future<Made> impl_;
};

} // namespace hyalite::gpu
