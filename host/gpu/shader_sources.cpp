// Resolves includes below the shaders folder.
#include "gpu/shader_sources.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <regex>

namespace hyalite::gpu {
namespace {

namespace fs = std::filesystem;

// Symbolic links are followed first, so that none leads out.
bool isInside(const fs::path& file, const fs::path& folder) {
    const fs::path path = fs::weakly_canonical(file);
    const fs::path root = fs::weakly_canonical(folder);
    return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

// Throws Error(BadInput) when the file cannot be read.
std::string readText(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream.is_open() || stream.bad()) {
        throw Error(ExitCode::BadInput, "cannot read " + file.string());
    }
    return text;
}

} // namespace

ShaderSources::ShaderSources(fs::path folder) : folder_(std::move(folder)) {}

std::optional<fs::path> ShaderSources::resolve(const std::string& name, const fs::path& includer) const {
    const std::array candidates{includer.parent_path() / name, folder_ / name};
    for (const fs::path& candidate : candidates) {
        if (fs::is_regular_file(candidate) && isInside(candidate, folder_)) {
            return candidate.lexically_normal();
        }
    }
    return std::nullopt;
}

SourceTexts ShaderSources::reach(const fs::path& file) const {
    static const std::regex includeLine(R"([ \t]*#[ \t]*include[ \t]*["<]([^">\n]+)[">])");
    SourceTexts texts;
    std::vector<fs::path> open{file.lexically_normal()};
    while (!open.empty()) {
        const fs::path path = open.back();
        open.pop_back();
        const auto [entry, isNew] = texts.try_emplace(path.string());
        if (!isNew) {
            continue;
        }
        entry->second = readText(path);
        const std::string& text = entry->second;
        for (std::sregex_iterator match(text.begin(), text.end(), includeLine), end; match != end; ++match) {
            // What is not there is for the compiler to judge: it knows whether the line counts.
            if (const std::optional<fs::path> included = resolve((*match)[1], path)) {
                open.push_back(*included);
            }
        }
    }
    return texts;
}

} // namespace hyalite::gpu
