// GLSL kernels to SPIR-V at run time, by the glslang library, with #include and a cache on disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hyalite::gpu {

using SpirV = std::vector<std::uint32_t>;

class ShaderCompiler {
public:
    // `shaders`: the folder that holds kernels/, lib/ and shared/. `cache`: where compiled kernels are kept, named by
    // a hash of all their source text and of the compiler's version; empty: no cache. `shipped`: a folder of the same
    // kind that is only read.
    explicit ShaderCompiler(std::filesystem::path shaders, std::filesystem::path cache = {},
                            std::filesystem::path shipped = {});

    // Compiles kernels/<kernel>.comp. #include "lib/x.glsl" is looked for beside the including file, then in the
    // shaders folder. Throws Error(BadInput) at file:line of the source that is wrong, naming the kernel.
    [[nodiscard]] SpirV compile(const std::string& kernel) const;

    [[nodiscard]] const std::filesystem::path& shaders() const { return shaders_; }

private:
    std::filesystem::path shaders_;
    std::filesystem::path cache_;
    std::filesystem::path shipped_;
};

} // namespace hyalite::gpu
