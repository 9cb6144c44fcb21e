// Resolves includes below the shaders folder.
#include "gpu/shader_sources.h"

#include "base/error.h"
#include "base/folders.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
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

// The name in a line like #ifdef NAME, for the directive `ifdef`; empty: another line.
std::string nameAfter(const std::string& line, std::string_view directive) {
    std::istringstream words(line);
    std::string first;
    std::string name;
    words >> first >> name;
    return first == '#' + std::string(directive) ? name : std::string();
}

// The #ifdef that the present line of a file stands in. Only names of hyalite's own count, since they are defined in
// these files alone; any other condition is taken to hold.
class Conditions {
public:
    void read(const std::string& line) {
        std::istringstream words(line);
        std::string directive;
        words >> directive;
        if (directive == "#endif" && !needed_.empty()) {
            needed_.pop_back();
        } else if ((directive == "#else" || directive == "#elif") && !needed_.empty()) {
            needed_.back().clear();
        } else if (directive.starts_with("#if")) {
            const std::string name = nameAfter(line, "ifdef");
            needed_.push_back(name.starts_with("HYALITE_") ? name : std::string());
        }
    }
    // A name that must be defined here; empty: none that is known.
    [[nodiscard]] std::string needed() const {
        const auto found = std::ranges::find_if(needed_, [](const std::string& name) { return !name.empty(); });
        return found == needed_.end() ? std::string() : *found;
    }

private:
    std::vector<std::string> needed_; // by depth
};

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
    std::set<std::string> defined{"HYALITE_CHECKED"}; // by the compiler, for checked kernels
    std::multimap<std::string, fs::path> waiting;     // files whose #include needs a name that no file has defined yet
    std::vector<fs::path> open{file.lexically_normal()};
    const auto define = [&](const std::string& name) {
        defined.insert(name);
        const auto [begin, end] = waiting.equal_range(name);
        std::transform(begin, end, std::back_inserter(open), [](const auto& entry) { return entry.second; });
        waiting.erase(begin, end);
    };
    while (!open.empty()) {
        const fs::path path = open.back();
        open.pop_back();
        const auto [entry, isNew] = texts.try_emplace(path.string());
        if (!isNew) {
            continue;
        }
        entry->second = readText(path);
        Conditions conditions;
        std::istringstream lines(entry->second);
        for (std::string line; std::getline(lines, line);) {
            conditions.read(line);
            if (const std::string name = nameAfter(line, "define"); !name.empty()) {
                define(name);
            }
            const std::optional<std::string> name = includedName(line);
            // A missing file is for the compiler to report: it knows whether the line is active.
            const auto included = name ? resolve(*name, path) : std::nullopt;
            if (included && conditions.needed().empty()) {
                open.push_back(*included);
            } else if (included) {
                waiting.emplace(conditions.needed(), *included);
                if (defined.contains(conditions.needed())) {
                    define(conditions.needed());
                }
            }
        }
    }
    return texts;
}

} // namespace hyalite::gpu
