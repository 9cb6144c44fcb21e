// See custom_twins.h.
#include "reference/bsdf/custom_twins.h"

#include "base/fnv.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <dlfcn.h>
#include <span>

namespace hyalite::reference {

namespace {

namespace fs = std::filesystem;

struct LoadedTwin {
    fs::path file;
    std::shared_ptr<const CodeTwin> twin; // keeps the shared object loaded
};

std::string hexadecimal(std::uint64_t hash) {
    std::array<char, 19> text{};
    std::snprintf(text.data(), text.size(), "0x%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

std::uint64_t hashOf(const CustomCode& code) {
    return fnv(std::as_bytes(std::span(code.text)));
}

LoadedTwin loadTwin(const fs::path& file) {
    const auto fail = [&](const std::string& what, const std::string& hint) {
        throw Error(ExitCode::WrongUsage, SourceLocation{.file = file.string()}, what, hint);
    };
    // dlopen would search the system's folders for a bare file name
    void* const object = ::dlopen(fs::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (object == nullptr) {
        const char* const reason = ::dlerror(); // NOLINT(concurrency-mt-unsafe): it reports this thread's call
        fail(std::string("cannot load the twin: ") + (reason == nullptr ? "unknown reason" : reason),
             "docs/experiments.md says how twins are built");
    }
    const std::shared_ptr<void> held(object, [](void* loaded) { ::dlclose(loaded); });
    const auto* const twin = static_cast<const CodeTwin*>(::dlsym(object, "hyaliteTwin"));
    if (twin == nullptr) {
        fail("not a twin: it does not define hyaliteTwin", "docs/experiments.md says how twins are written");
    }
    if (twin->layout != CodeTwin::kLayout) {
        fail("the twin was built for another version of hyalite", "build it again");
    }
    if (twin->function == nullptr || (twin->texture == nullptr) == (twin->reflectance == nullptr)) {
        fail("not a twin: it needs the function's name, and a texture or a reflectance",
             "docs/experiments.md says how twins are written");
    }
    return {file, {held, twin}};
}

std::vector<LoadedTwin> loadTwins(std::vector<fs::path> files, const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code ignored; // on error there are no twins
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        if (entry.path().string().ends_with(".twin.so")) {
            found.push_back(entry.path());
        }
    }
    std::ranges::sort(found);
    files.insert(files.end(), found.begin(), found.end());
    std::vector<LoadedTwin> twins;
    std::ranges::transform(files, std::back_inserter(twins), loadTwin);
    return twins;
}

std::shared_ptr<const CustomCode> withTwin(const std::shared_ptr<const CustomCode>& code,
                                           const std::vector<LoadedTwin>& twins) {
    auto result = std::make_shared<CustomCode>(*code);
    result->twin = nullptr;
    result->twinRefused.clear();
    for (const auto& [file, twin] : twins) {
        if (twin->function != code->function) {
            continue;
        }
        if (twin->codeHash == hashOf(*code)) {
            result->twin = twin;
            result->twinRefused.clear();
            break;
        }
        result->twinRefused = file.string();
    }
    return result;
}

// Calls visit(code) with each shared_ptr<const CustomCode> of the scene that may have a twin.
template <class S, class Visit>
void visitCodes(S& scene, Visit&& visit) {
    for (auto& texture : scene.textures) {
        if (auto* custom = std::get_if<CustomTexture>(&texture.model)) {
            visit(custom->code);
        }
    }
    for (auto& material : scene.materials) {
        if (material.model.code != nullptr) {
            visit(material.model.code);
        }
    }
}

} // namespace

void attachTwins(Scene& scene, const TwinSources& sources) {
    bool hasCode = false;
    visitCodes(scene, [&](const auto&) { hasCode = true; });
    const std::vector<LoadedTwin> twins = loadTwins(sources.files, hasCode ? sources.folder : fs::path());
    visitCodes(scene, [&](std::shared_ptr<const CustomCode>& code) { code = withTwin(code, twins); });
}

TextureTwin customTextureTwin(const CustomCode& code) {
    return code.twin == nullptr ? nullptr : code.twin->texture;
}

ReflectanceTwin customReflectanceTwin(const CustomCode& code) {
    return code.twin == nullptr ? nullptr : code.twin->reflectance;
}

const CustomCode* textureWithoutTwin(const Scene& scene) {
    for (const Texture& texture : scene.textures) {
        const auto* custom = std::get_if<CustomTexture>(&texture.model);
        if (custom != nullptr && customTextureTwin(*custom->code) == nullptr) {
            return custom->code.get();
        }
    }
    return nullptr;
}

const CustomCode* reflectanceWithoutTwin(const Scene& scene) {
    for (const Material& material : scene.materials) {
        const CustomCode* code = material.model.code.get();
        if (code != nullptr && customReflectanceTwin(*code) == nullptr) {
            return code;
        }
    }
    return nullptr;
}

const CustomCode* codeWithoutTwin(const Scene& scene) {
    const CustomCode* texture = textureWithoutTwin(scene);
    const CustomCode* reflectance = reflectanceWithoutTwin(scene);
    return texture != nullptr       ? texture
           : reflectance != nullptr ? reflectance
                                    : scene.render.photonMap.customFilter.get();
}

Error noTwin(const CustomCode& code) {
    const std::string other = code.twinRefused.empty() ? "" : ": " + code.twinRefused + " is the twin of other code";
    return {ExitCode::WrongUsage,
            {.file = code.file, .line = code.line},
            "there is no twin of '" + code.function + '\'' + other,
            "render with --backend vulkan, or give a texture or material a twin by --twins: docs/experiments.md; the "
            "hash of this code is " +
                hexadecimal(hashOf(code))};
}

} // namespace hyalite::reference
