// The files that a kernel is made of: how an #include finds its file, and all text that one kernel can reach.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace hyalite::gpu {

using SourceTexts = std::map<std::string, std::string>; // by path

// Reads below one shaders folder and nowhere else.
class ShaderSources {
public:
    explicit ShaderSources(std::filesystem::path folder);

    // The file that `name`, included by `includer`, means: beside the includer, else below the folder. Nothing when
    // there is none, or none inside the folder.
    [[nodiscard]] std::optional<std::filesystem::path> resolve(const std::string& name,
                                                               const std::filesystem::path& includer) const;

    // Path and text of every file that `file` reaches through #include lines, itself among them. Lines that the
    // preprocessor would skip count too: rather one file too many in a cache's key than one too few.
    [[nodiscard]] SourceTexts reach(const std::filesystem::path& file) const;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;
};

} // namespace hyalite::gpu
