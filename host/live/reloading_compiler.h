// A shader compiler that goes on with what it had: where a kernel's present source does not compile, or has brought a
// worker down, its last good version stands in.
#pragma once

#include "base/error.h"
#include "gpu/shader_compiler.h"

#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>

namespace hyalite::live {

// Versions of kernels, by their names in the cache.
struct KernelVersions {
    std::map<std::string, std::string> good; // by kernel: one with which a pass has come to its end
    std::set<std::string> bad;               // that hung or crashed
};

class ReloadingCompiler final : public gpu::KernelCompiler {
public:
    // `onCompiled`: called, from any thread, with each kernel and the version of it that will run.
    ReloadingCompiler(std::filesystem::path shaders, std::filesystem::path cache, std::filesystem::path shipped,
                      KernelVersions versions, std::function<void(const std::string&, const std::string&)> onCompiled);

    // See gpu::ShaderCompiler.
    void replace(std::map<std::string, std::string> texts) { compiler_.replace(std::move(texts)); }

    // Throws Error(BadInput) where there is no version that compiles.
    [[nodiscard]] gpu::SpirV compile(const std::string& kernel) const override;
    [[nodiscard]] gpu::SpirV specialized(const std::string& kernel, const gpu::SpirV& spirv,
                                         const std::map<std::uint32_t, std::uint32_t>& constants) const override {
        return compiler_.specialized(kernel, spirv, constants);
    }
    [[nodiscard]] std::vector<std::string> sourceFiles(const std::string& kernel) const override {
        return compiler_.sourceFiles(kernel);
    }
    [[nodiscard]] std::uint64_t hashOfSources(std::span<const std::string_view> kernels) const override {
        return compiler_.hashOfSources(kernels);
    }
    [[nodiscard]] const std::filesystem::path& shaders() const override { return compiler_.shaders(); }

    // Kernels compiled before whose sources are others now; and forgets their errors.
    [[nodiscard]] std::set<std::string> takeChanged();

    [[nodiscard]] std::map<std::string, Error> errors() const;        // by kernel: why its present source does not run
    [[nodiscard]] std::map<std::string, std::string> running() const; // by kernel: the version compiled last
    [[nodiscard]] std::set<std::string> standIns() const; // kernels that run an older version than their source

    // All that runs has proved good.
    [[nodiscard]] KernelVersions noteGood();
    // What runs and has not yet proved good is bad: their names in the cache.
    [[nodiscard]] std::set<std::string> noteBad();

private:
    // `isKnown`: whoever stopped the kernel has said so.
    [[nodiscard]] gpu::SpirV lastGood(const std::string& kernel, const Error& why, bool isKnown) const;

    gpu::ShaderCompiler compiler_; // of the present sources
    std::function<void(const std::string&, const std::string&)> onCompiled_;
    mutable std::mutex mutex_; // of all below
    mutable KernelVersions versions_;
    mutable std::map<std::string, std::string> sources_; // by kernel: the version of the present source
    mutable std::map<std::string, std::string> running_; // by kernel: what was compiled last
    mutable std::map<std::string, Error> errors_;
};

} // namespace hyalite::live
