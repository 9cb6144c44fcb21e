// A shader compiler that falls back on earlier versions: when a kernel's present source does not compile, or has
// brought a worker down, its last good version stands in.
#pragma once

#include "base/error.h"
#include "gpu/shader_compiler.h"
#include "live/messages/messages.h"

#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>

namespace hyalite::live {

class ReloadingCompiler final : public gpu::KernelCompiler {
public:
    // `onCompiled` is called from any thread, with a kernel and the version of it that will run.
    ReloadingCompiler(std::filesystem::path shaders, std::filesystem::path cache, std::filesystem::path shipped,
                      KernelVersions versions, std::function<void(const std::string&, const std::string&)> onCompiled);

    // See gpu::ShaderCompiler.
    void replace(std::map<std::string, std::string> texts) { compiler_.replace(std::move(texts)); }

    // Throws Error(BadInput) when no version compiles.
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

    // The kernels whose sources have changed since they were compiled; forgets their errors.
    [[nodiscard]] std::set<std::string> takeChanged();

    [[nodiscard]] std::map<std::string, Error> errors() const;        // by kernel: why its present source does not run
    [[nodiscard]] std::map<std::string, std::string> running() const; // by kernel: the version compiled last
    [[nodiscard]] std::set<std::string> standIns() const; // kernels that run an older version than their source

    // Every version that runs has proved good.
    [[nodiscard]] KernelVersions noteGood();
    // Every version that runs and has not proved good is bad; returns their names in the cache.
    [[nodiscard]] std::set<std::string> noteBad();

private:
    // `isKnown`: the server has reported why the present version does not run.
    [[nodiscard]] gpu::SpirV lastGood(const std::string& kernel, const Error& why, bool isKnown) const;

    gpu::ShaderCompiler compiler_; // of the present sources
    std::function<void(const std::string&, const std::string&)> onCompiled_;
    mutable std::mutex mutex_; // of everything below
    mutable KernelVersions versions_;
    mutable std::map<std::string, std::string> sources_; // by kernel: the version of the present source
    mutable std::map<std::string, std::string> running_; // by kernel: what was compiled last
    mutable std::map<std::string, Error> errors_;
};

} // namespace hyalite::live
