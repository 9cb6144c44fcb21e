// A kernel's source files: how an #include finds its file, and all text that a kernel can reach.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace hyalite::gpu {

using SourceTexts = std::map<std::string, std::string>; // by path

// Reads only below one shaders folder.
class ShaderSources {
public:
    explicit ShaderSources(std::filesystem::path folder);

    // The file that `name` refers to when `includer` includes it: next to the includer, else below the folder. None if
    // it does not exist or is outside the folder.
    [[nodiscard]] std::optional<std::filesystem::path> resolve(const std::string& name,
                                                               const std::filesystem::path& includer) const;

    // Path and text of every file that `file` reaches through #include lines, including itself. Lines in an #ifdef of a
    // name HYALITE_… that no file reached defines do not count. Others that the preprocessor would skip do: one file
    // too many in a cache key is better than one too few.
    [[nodiscard]] SourceTexts reach(const std::filesystem::path& file) const;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;
};

} // namespace hyalite::gpu
