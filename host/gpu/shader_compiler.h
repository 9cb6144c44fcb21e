// GLSL kernels to SPIR-V at run time, by the glslang library, with #include and a cache on disk.
#pragma once

#include "gpu/kernel_compiler.h"

#include <optional>
#include <span>
#include <string_view>

namespace hyalite::gpu {

// Name and version of every library that makes SPIR-V here: glslang, and SPIRV-Tools, which optimizes.
[[nodiscard]] std::string compilerVersions();

class ShaderCompiler final : public KernelCompiler {
public:
    // `shaders`: the folder that holds kernels/, lib/ and shared/. `cache`: where compiled kernels are kept, named by
    // a hash of all their source text and of `versions`; empty: no cache. `shipped`: a folder of the same kind that is
    // only read.
    explicit ShaderCompiler(std::filesystem::path shaders, std::filesystem::path cache = {},
                            std::filesystem::path shipped = {}, std::string versions = compilerVersions());

    // From now on these texts stand in place of files of the shaders folder, named relative to it.
    void replace(std::map<std::string, std::string> texts) { replaced_ = std::move(texts); }

    // #include "lib/x.glsl" is looked for beside the including file, then in the shaders folder.
    [[nodiscard]] SpirV compile(const std::string& kernel) const override;

    // What the kernel is called in the cache: another name whenever any text that it reaches is another. Throws
    // Error(BadInput) where it is not there.
    [[nodiscard]] std::string nameInCache(const std::string& kernel) const;
    [[nodiscard]] std::optional<SpirV> fromCache(const std::string& nameInCache) const;

    // The result is kept in the cache, too.
    [[nodiscard]] SpirV specialized(const std::string& kernel, const SpirV& spirv,
                                    const std::map<std::uint32_t, std::uint32_t>& constants) const override;

    [[nodiscard]] std::vector<std::string> sourceFiles(const std::string& kernel) const override;

    // A number that changes with any source below the shaders folder.
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
