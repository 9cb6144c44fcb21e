// A compute pipeline whose interface is read from its SPIR-V.
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
    std::string type = {}; // GLSL's, e.g. "vec3"; of a device array that of its elements, e.g. "Ray"
    bool isArray = false;  // a device array: the member holds its address
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

// Copies are the same pipeline.
class Kernel {
public:
    Kernel(const Context& context, const TexelTables& tables, const KernelCompiler& compiler, const std::string& name,
           const Specialization& specialization = {});

    // The same, but another core makes it while the caller goes on: what is wrong with it is thrown where it is first
    // used. The arguments must outlive the kernel and its copies.
    [[nodiscard]] static Kernel inBackground(const Context& context, const TexelTables& tables,
                                             const KernelCompiler& compiler, std::string name,
                                             const Specialization& specialization = {});

    // These wait until it is made.
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
