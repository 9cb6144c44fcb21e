#include "live/worker/reloading_compiler.h"

namespace hyalite::live {

ReloadingCompiler::ReloadingCompiler(std::filesystem::path shaders, std::filesystem::path cache,
                                     std::filesystem::path shipped, KernelVersions versions,
                                     std::function<void(const std::string&, const std::string&)> onCompiled)
    : compiler_(std::move(shaders), std::move(cache), std::move(shipped)), onCompiled_(std::move(onCompiled)),
      versions_(std::move(versions)) {}

gpu::SpirV ReloadingCompiler::compile(const std::string& kernel) const {
    bool isBad = false;
    try {
        const std::string name = compiler_.nameInCache(kernel);
        {
            const std::scoped_lock lock(mutex_);
            sources_[kernel] = name;
            isBad = versions_.bad.contains(name);
        }
        if (isBad) {
            throw Error(ExitCode::Device, "kernel '" + kernel + "' hung or crashed");
        }
        gpu::SpirV spirv = compiler_.compile(kernel);
        onCompiled_(kernel, name);
        const std::scoped_lock lock(mutex_);
        running_[kernel] = name;
        errors_.erase(kernel);
        return spirv;
    } catch (const Error& error) {
        return lastGood(kernel, error, isBad);
    }
}

gpu::SpirV ReloadingCompiler::lastGood(const std::string& kernel, const Error& why, bool isKnown) const {
    std::string name;
    {
        const std::scoped_lock lock(mutex_);
        if (!isKnown) {
            errors_.insert_or_assign(kernel, why);
        }
        const auto good = versions_.good.find(kernel);
        name = good == versions_.good.end() ? std::string() : good->second;
    }
    std::optional<gpu::SpirV> spirv = name.empty() ? std::nullopt : compiler_.fromCache(name);
    if (!spirv) {
        throw Error(why);
    }
    onCompiled_(kernel, name);
    const std::scoped_lock lock(mutex_);
    running_[kernel] = name;
    return *std::move(spirv);
}

std::set<std::string> ReloadingCompiler::takeChanged() {
    std::map<std::string, std::string> before;
    {
        const std::scoped_lock lock(mutex_);
        before = sources_;
    }
    std::set<std::string> changed;
    for (const auto& [kernel, name] : before) {
        std::string now;
        try {
            now = compiler_.nameInCache(kernel);
        } catch (const Error&) {
            now.clear(); // compiling it reports the error
        }
        if (now != name) {
            changed.insert(kernel);
        }
    }
    const std::scoped_lock lock(mutex_);
    for (const std::string& kernel : changed) {
        errors_.erase(kernel);
    }
    return changed;
}

std::map<std::string, Error> ReloadingCompiler::errors() const {
    const std::scoped_lock lock(mutex_);
    return errors_;
}

std::map<std::string, std::string> ReloadingCompiler::running() const {
    const std::scoped_lock lock(mutex_);
    return running_;
}

std::set<std::string> ReloadingCompiler::standIns() const {
    const std::scoped_lock lock(mutex_);
    std::set<std::string> kernels;
    for (const auto& [kernel, name] : running_) {
        if (const auto source = sources_.find(kernel); source != sources_.end() && source->second != name) {
            kernels.insert(kernel);
        }
    }
    return kernels;
}

KernelVersions ReloadingCompiler::noteGood() {
    const std::scoped_lock lock(mutex_);
    for (const auto& [kernel, name] : running_) {
        versions_.good[kernel] = name;
    }
    return versions_;
}

std::set<std::string> ReloadingCompiler::noteBad() {
    const std::scoped_lock lock(mutex_);
    std::set<std::string> names;
    for (const auto& [kernel, name] : running_) {
        const auto good = versions_.good.find(kernel);
        if (good == versions_.good.end() || good->second != name) {
            versions_.bad.insert(name);
            names.insert(name);
        }
    }
    return names;
}

} // namespace hyalite::live
