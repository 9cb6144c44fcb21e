// Resolves includes below the shaders folder.
#include "gpu/shader_sources.h"

#include "base/error.h"
#include "base/folders.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <vector>

namespace hyalite::gpu {
namespace {

namespace fs = std::filesystem;

// The name in a line like # include "name".
std::optional<std::string> includedName(std::string_view line) {
    for (const std::string_view word : {"#", "include"}) {
        const std::size_t start = line.find_first_not_of(" \t");
        if (start == std::string_view::npos || !line.substr(start).starts_with(word)) {
            return std::nullopt;
        }
        line.remove_prefix(start + word.size());
    }
    const std::size_t open = line.find_first_of("\"<");
    const std::size_t close = line.find_last_of("\">");
    if (open == std::string_view::npos || close <= open) {
        return std::nullopt;
    }
    return std::string(line.substr(open + 1, line.find_first_of("\">", open + 1) - open - 1));
}

// Throws Error(BadInput) if the file cannot be read.
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
        std::istringstream lines(entry->second);
        for (std::string line; std::getline(lines, line);) {
            const std::optional<std::string> name = includedName(line);
            // A missing file is for the compiler to report: it knows whether the line is active.
            if (const auto included = name ? resolve(*name, path) : std::nullopt) {
                open.push_back(*included);
            }
        }
    }
    return texts;
}

} // namespace hyalite::gpu
