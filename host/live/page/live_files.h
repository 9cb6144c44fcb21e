// The files that the page may read and, with --edit, write: shaders, the scene file, and the GLSL files that it names.
// No path leads anywhere else, not through symbolic links either.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hyalite::live {

class LiveFiles {
public:
    LiveFiles(const std::filesystem::path& shaders, const std::filesystem::path& scene);

    // The same, with these GLSL files of the scene; files outside the scene's folder are left out.
    [[nodiscard]] LiveFiles withCode(const std::vector<std::string>& files) const;

    // The page's names of all files: "shaders/kernels/x.comp", "scene/room.yaml", "scene/marble.glsl"; sorted.
    [[nodiscard]] std::vector<std::string> names() const;

    // Whether any of the files contains the text, except lib/debug.glsl. Reads them all.
    [[nodiscard]] bool anyShaderHas(const std::string& text) const;

    // The file of that name; nothing when there is none, or the page may not read it.
    [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& name) const;
    // The page's name of a file; empty when the page may not read it.
    [[nodiscard]] std::string nameOf(const std::filesystem::path& file) const;

private:
    std::filesystem::path shaders_; // canonical
    std::filesystem::path scene_;   // canonical
    std::vector<std::filesystem::path> code_;
};

} // namespace hyalite::live
