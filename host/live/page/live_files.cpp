#include "live/page/live_files.h"

#include "base/folders.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

namespace hyalite::live {

namespace {

namespace fs = std::filesystem;

bool isShader(const fs::path& file) {
    const fs::path extension = file.extension();
    return extension == ".comp" || extension == ".glsl" || extension == ".h";
}

// Nothing when the file does not exist.
std::optional<fs::path> canonicalFile(const fs::path& path) {
    std::error_code error;
    fs::path file = fs::canonical(path, error);
    if (error || !fs::is_regular_file(file, error)) {
        return std::nullopt;
    }
    return file;
}

} // namespace

LiveFiles::LiveFiles(const fs::path& shaders, const fs::path& scene)
    : shaders_(fs::weakly_canonical(shaders)), scene_(fs::weakly_canonical(scene)) {}

LiveFiles LiveFiles::withCode(const std::vector<std::string>& files) const {
    LiveFiles result = *this;
    result.code_.clear();
    for (const std::string& name : files) {
        const auto file = canonicalFile(name);
        if (file && file->extension() == ".glsl" && isInside(*file, scene_.parent_path())) {
            result.code_.push_back(*file);
        }
    }
    return result;
}

std::vector<std::string> LiveFiles::names() const {
    std::vector<std::string> names;
    std::error_code ignored;
    for (fs::recursive_directory_iterator entry(shaders_, ignored);
         !ignored && entry != fs::recursive_directory_iterator(); entry.increment(ignored)) {
        const auto file = isShader(entry->path()) ? canonicalFile(entry->path()) : std::nullopt;
        if (file && isInside(*file, shaders_)) {
            names.push_back("shaders/" + file->lexically_relative(shaders_).string());
        }
    }
    names.push_back("scene/" + scene_.filename().string());
    for (const fs::path& file : code_) {
        names.push_back("scene/" + file.lexically_relative(scene_.parent_path()).string());
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

bool LiveFiles::anyShaderHas(const std::string& text) const {
    const std::vector<std::string> all = names();
    return std::ranges::any_of(all, [&](const std::string& name) {
        const auto file = name == "shaders/lib/debug.glsl" ? std::nullopt : find(name);
        std::ifstream stream(file.value_or(fs::path()), std::ios::binary);
        const std::string content{std::istreambuf_iterator<char>(stream), {}};
        return content.find(text) != std::string::npos;
    });
}

std::optional<fs::path> LiveFiles::find(const std::string& name) const {
    if (name.find('\0') != std::string::npos) {
        return std::nullopt;
    }
    if (name.starts_with("shaders/")) {
        const auto file = canonicalFile(shaders_ / name.substr(8));
        return file && isInside(*file, shaders_) && isShader(*file) ? file : std::nullopt;
    }
    if (name.starts_with("scene/")) {
        const auto file = canonicalFile(scene_.parent_path() / name.substr(6));
        const bool isKnown = file && (*file == scene_ || std::ranges::find(code_, *file) != code_.end());
        return isKnown ? file : std::nullopt;
    }
    return std::nullopt;
}

std::string LiveFiles::nameOf(const fs::path& path) const {
    const auto file = canonicalFile(path);
    if (!file) {
        return {};
    }
    if (isInside(*file, shaders_) && isShader(*file)) {
        return "shaders/" + file->lexically_relative(shaders_).string();
    }
    if (*file == scene_ || std::ranges::find(code_, *file) != code_.end()) {
        return "scene/" + file->lexically_relative(scene_.parent_path()).string();
    }
    return {};
}

} // namespace hyalite::live
