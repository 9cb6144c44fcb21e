// Compiles GLSL kernels to SPIR-V at run time with the glslang library, with #include and a cache on disk.
#pragma once

#include "gpu/kernel_compiler.h"

#include <optional>
#include <span>
#include <string_view>

namespace hyalite::gpu {

// Name and version of every library that produces SPIR-V here: glslang, and SPIRV-Tools, which optimizes.
[[nodiscard]] std::string compilerVersions();

class ShaderCompiler final : public KernelCompiler {
public:
    // `shaders`: the folder that contains kernels/, lib/ and shared/. `cache`: the folder of compiled kernels, named by
    // a hash of all their source text and of `versions`; empty: no cache. `shipped`: a second such folder, read-only.
    explicit ShaderCompiler(std::filesystem::path shaders, std::filesystem::path cache = {},
                            std::filesystem::path shipped = {}, std::string versions = compilerVersions());

    // From now on these texts replace files of the shaders folder, named relative to it.
    void replace(std::map<std::string, std::string> texts) { replaced_ = std::move(texts); }

    // #include "lib/x.glsl" is resolved next to the including file, then in the shaders folder.
    [[nodiscard]] SpirV compile(const std::string& kernel) const override;

    // The kernel's name in the cache; it changes with any text that the kernel reaches. Throws Error(BadInput) if the
    // kernel does not exist.
    [[nodiscard]] std::string nameInCache(const std::string& kernel) const;
    [[nodiscard]] std::optional<SpirV> fromCache(const std::string& nameInCache) const;

    // The result is also cached.
    [[nodiscard]] SpirV specialized(const std::string& kernel, const SpirV& spirv,
                                    const std::map<std::uint32_t, std::uint32_t>& constants) const override;

    [[nodiscard]] std::vector<std::string> sourceFiles(const std::string& kernel) const override;

    // A hash of every source below the shaders folder.
    [[nodiscard]] std::uint64_t hashOfSources() const;
    [[nodiscard]] std::uint64_t hashOfSources(std::span<const std::string_view> kernels) const override;

    [[nodiscard]] const std::filesystem::path& shaders() const override { return shaders_; }

private:
    struct Sources;
    [[nodiscard]] Sources sourcesOf(const std::string& kernel) const;

    std::filesystem::path shaders_;
    std::filesystem::path cache_;
    std::filesystem::path shipped_;
    std::string versions_;
    std::map<std::string, std::string> replaced_;
};

} // namespace hyalite::gpu
