// Drives glslang: one compute kernel in, SPIR-V 1.6 for Vulkan 1.3 out.
#include "gpu/shader_compiler.h"

#include "base/error.h"
#include "base/fnv.h"
#include "gpu/checked_kernels.h"
#include "gpu/shader_sources.h"
#include "gpu/spirv_cache.h"
#include "gpu/spirv_optimizer.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <glslang/build_info.h>
#include <spirv-tools/libspirv.h>

namespace hyalite::gpu {
namespace {

namespace fs = std::filesystem;

// Change it whenever the options below change the output for the same source.
constexpr const char* kCacheFormat = kCheckedKernels ? "hyalite 2, vulkan 1.3, spirv 1.6, inlined, checked"
                                                     : "hyalite 2, vulkan 1.3, spirv 1.6, inlined";

constexpr auto kMessages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);

// glslang's tables, initialised once per process.
struct GlslangProcess {
    GlslangProcess() { glslang::InitializeProcess(); }
    ~GlslangProcess() { glslang::FinalizeProcess(); }
    GlslangProcess(const GlslangProcess&) = delete;
    GlslangProcess& operator=(const GlslangProcess&) = delete;
};

// Gives glslang the texts that were read beforehand: the ones that the cache key was computed from, even if a file is
// saved in the meantime. Names are full paths.
class Includer : public glslang::TShader::Includer {
public:
    Includer(const ShaderSources& sources, const SourceTexts& texts) : sources_(sources), texts_(texts) {}

    IncludeResult* includeLocal(const char* name, const char* includer, std::size_t /*depth*/) override {
        return include(name, includer);
    }
    // glslang calls this after a failure above, and reports the reason from this result.
    IncludeResult* includeSystem(const char* name, const char* includer, std::size_t /*depth*/) override {
        return include(name, includer);
    }
    void releaseInclude(IncludeResult* result) override { delete result; }

private:
    // glslang owns the result until it returns it; an empty path marks a failure whose text is the reason.
    [[nodiscard]] IncludeResult* include(const std::string& name, const std::string& includer) const {
        if (const std::optional<fs::path> file = sources_.resolve(name, includer)) {
            if (const auto found = texts_.find(file->string()); found != texts_.end()) {
                return new IncludeResult(found->first, found->second.data(), found->second.size(), nullptr);
            }
        }
        return new IncludeResult("", refusal_.data(), refusal_.size(), nullptr);
    }

    const ShaderSources& sources_;
    const SourceTexts& texts_;
    std::string refusal_ = "no such file next to the including file or below the shaders folder";
};

// "file:line: message" in its parts; line 0 and no file if the text does not begin with a location.
struct Diagnostic {
    SourceLocation where;
    std::string message;
};

Diagnostic readDiagnostic(const std::string& text) {
    for (std::size_t colon = text.find(':'); colon != std::string::npos; colon = text.find(':', colon + 1)) {
        const std::size_t end = text.find_first_not_of("0123456789", colon + 1);
        if (end != std::string::npos && end > colon + 1 && text.compare(end, 2, ": ") == 0) {
            const int line = std::stoi(text.substr(colon + 1, end - colon - 1));
            return {.where = {.file = text.substr(0, colon), .line = line}, .message = text.substr(end + 2)};
        }
    }
    return {.where = {}, .message = text};
}

// The exception for the first error in glslang's log, which has one error per line.
Error compileError(const std::string& kernel, const fs::path& file, const std::string& log) {
    const std::string mark = "ERROR: ";
    const std::size_t found = log.find(mark);
    const std::size_t start = found == std::string::npos ? 0 : found + mark.size();
    Diagnostic first = readDiagnostic(log.substr(start, log.find('\n', start) - start));
    if (first.where.file.empty()) {
        first.where.file = file.string();
    }
    return {ExitCode::BadInput, first.where, "kernel '" + kernel + "': " + first.message};
}

SpirV compileSource(const std::string& kernel, const fs::path& file, const ShaderSources& sources,
                    const SourceTexts& texts) {
    static const GlslangProcess process;
    glslang::TShader shader(EShLangCompute);
    const std::string& text = texts.at(file.string());
    const char* source = text.data();
    const int length = int(text.size());
    const std::string name = file.string();
    const char* names = name.c_str();
    shader.setStringsWithLengthsAndNames(&source, &length, &names, 1);
    shader.setPreamble(kCheckedKernels ? "#extension GL_GOOGLE_include_directive : require\n#define HYALITE_CHECKED\n"
                                       : "#extension GL_GOOGLE_include_directive : require\n");
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    Includer includer(sources, texts);
    if (!shader.parse(GetDefaultResources(), 460, ENoProfile, false, true, kMessages, includer)) {
        throw compileError(kernel, file, shader.getInfoLog());
    }
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(kMessages)) {
        throw compileError(kernel, file, program.getInfoLog());
    }
    SpirV spirv;
    spv::SpvBuildLogger logger;
    glslang::SpvOptions options;
    glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), spirv, &logger, &options);
    if (spirv.empty()) {
        throw compileError(kernel, file, logger.getAllMessages());
    }
    return inlineFunctions(std::move(spirv));
}

// Hash of names relative to the folder and of contents: the folder's own path does not matter.
std::uint64_t hashOf(const SourceTexts& texts, const fs::path& folder) {
    std::uint64_t hash = kFnvStart;
    for (const auto& [path, text] : texts) {
        const std::string name = fs::path(path).lexically_relative(folder).string() + '\n';
        hash = fnv(std::as_bytes(std::span(text)), fnv(std::as_bytes(std::span(name)), hash));
    }
    return hash;
}

} // namespace

std::string compilerVersions() {
    return "glslang " + std::to_string(GLSLANG_VERSION_MAJOR) + '.' + std::to_string(GLSLANG_VERSION_MINOR) + '.' +
           std::to_string(GLSLANG_VERSION_PATCH) + ", SPIRV-Tools " + spvSoftwareVersionString();
}

ShaderCompiler::ShaderCompiler(fs::path shaders, fs::path cache, fs::path shipped, std::string versions)
    : shaders_(std::move(shaders)), cache_(std::move(cache)), shipped_(std::move(shipped)),
      versions_(std::move(versions)) {}

struct ShaderCompiler::Sources {
    ShaderSources folder;
    fs::path file;
    SourceTexts texts;
    std::string nameInCache;
};

ShaderCompiler::Sources ShaderCompiler::sourcesOf(const std::string& kernel) const {
    const fs::path file = (shaders_ / "kernels" / (kernel + ".comp")).lexically_normal();
    if (!fs::is_regular_file(file)) {
        throw Error(ExitCode::BadInput, "no kernel '" + kernel + "' (" + file.string() + " does not exist)");
    }
    Sources sources{ShaderSources(shaders_), file, {}, {}};
    sources.texts = sources.folder.reach(file);
    for (const auto& [path, text] : replaced_) {
        if (const auto found = sources.texts.find((shaders_ / path).lexically_normal().string());
            found != sources.texts.end()) {
            found->second = text;
        }
    }
    std::string key = std::string(kCacheFormat) + '\n' + versions_ + '\n';
    for (const auto& [path, text] : sources.texts) {
        // The folder's path does not matter, its contents do.
        key += fs::path(path).lexically_relative(shaders_.lexically_normal()).string() + '\n' +
               std::to_string(text.size()) + '\n' + text;
    }
    sources.nameInCache = kernel + '-' + SpirvCache::key(key);
    return sources;
}

std::string ShaderCompiler::nameInCache(const std::string& kernel) const {
    return sourcesOf(kernel).nameInCache;
}

std::optional<SpirV> ShaderCompiler::fromCache(const std::string& nameInCache) const {
    std::optional<SpirV> shipped = SpirvCache(shipped_).load(nameInCache);
    return shipped ? std::move(shipped) : SpirvCache(cache_).load(nameInCache);
}

SpirV ShaderCompiler::compile(const std::string& kernel) const {
    Sources sources = sourcesOf(kernel);
    if (std::optional<SpirV> made = fromCache(sources.nameInCache)) {
        return *std::move(made);
    }
    if constexpr (kCheckedKernels) {
        std::uint32_t number = 0;
        for (auto& [path, text] : sources.texts) {
            const bool checksItself = fs::path(path).filename() == "checked.glsl";
            text = checksItself ? text : withBoundChecks(text, number);
            ++number;
        }
    }
    SpirV spirv = compileSource(kernel, sources.file, sources.folder, sources.texts);
    SpirvCache(cache_).store(sources.nameInCache, spirv);
    return spirv;
}

SpirV ShaderCompiler::specialized(const std::string& kernel, const SpirV& spirv,
                                  const std::map<std::uint32_t, std::uint32_t>& constants) const {
    std::string key = std::string(kCacheFormat) + '\n' + versions_ + '\n';
    for (const auto& [id, value] : constants) {
        key += std::to_string(id) + ' ' + std::to_string(value) + '\n';
    }
    key.append(reinterpret_cast<const char*>(spirv.data()), spirv.size() * sizeof(SpirV::value_type));
    const std::string name = kernel + "-specialized-" + SpirvCache::key(key);
    const SpirvCache cache(cache_);
    if (std::optional<SpirV> cached = cache.load(name)) {
        return *std::move(cached);
    }
    SpirV result = specialize(spirv, constants);
    cache.store(name, result);
    return result;
}

std::vector<std::string> ShaderCompiler::sourceFiles(const std::string& kernel) const {
    std::vector<std::string> names;
    for (const auto& [path, text] : sourcesOf(kernel).texts) {
        names.push_back(fs::path(path).lexically_relative(shaders_.lexically_normal()).string());
    }
    return names;
}

std::uint64_t ShaderCompiler::hashOfSources() const {
    const ShaderSources sources(shaders_);
    SourceTexts texts;
    for (const auto& entry : fs::directory_iterator(shaders_ / "kernels")) {
        if (entry.path().extension() == ".comp") {
            texts.merge(sources.reach(entry.path()));
        }
    }
    for (const auto& [path, text] : replaced_) {
        texts[(shaders_ / path).lexically_normal().string()] = text;
    }
    return hashOf(texts, shaders_.lexically_normal());
}

std::uint64_t ShaderCompiler::hashOfSources(std::span<const std::string_view> kernels) const {
    SourceTexts texts;
    for (const std::string_view kernel : kernels) {
        texts.merge(sourcesOf(std::string(kernel)).texts);
    }
    return hashOf(texts, shaders_.lexically_normal());
}

} // namespace hyalite::gpu
