// The compiler interface that a Kernel uses.
#pragma once

#include "gpu/spirv.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite::gpu {

// Implementations are final, so copies cannot be sliced.
class KernelCompiler {
public:
    virtual ~KernelCompiler() = default;
    KernelCompiler() = default;

    // Compiles kernels/<kernel>.comp. Throws Error(BadInput) at the file:line of the source error, naming the kernel.
    [[nodiscard]] virtual SpirV compile(const std::string& kernel) const = 0;

    // The result of compile(kernel), with values in place of its specialization constants, by id.
    [[nodiscard]] virtual SpirV specialized(const std::string& kernel, const SpirV& spirv,
                                            const std::map<std::uint32_t, std::uint32_t>& constants) const = 0;

    // The kernel's source files, relative to shaders(), in the order in which checked builds number them.
    [[nodiscard]] virtual std::vector<std::string> sourceFiles(const std::string& kernel) const = 0;

    // A hash of all sources that these kernels reach. Throws Error(BadInput) if one is missing.
    [[nodiscard]] virtual std::uint64_t hashOfSources(std::span<const std::string_view> kernels) const = 0;

    [[nodiscard]] virtual const std::filesystem::path& shaders() const = 0;

protected:
    KernelCompiler(const KernelCompiler&) = default;
    KernelCompiler& operator=(const KernelCompiler&) = default;
};

} // namespace hyalite::gpu
