// The files that the page may read and, where the server was told so, write: shaders, the scene file, and the code that
// it names. No path leads anywhere else, through symbolic links either.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hyalite::live {

class LiveFiles {
public:
    LiveFiles(const std::filesystem::path& shaders, const std::filesystem::path& scene);

    // The GLSL files that the scene names; those outside its folder are left out.
    void setCode(const std::vector<std::string>& files);

    // What the page calls them: "shaders/kernels/x.comp", "scene/room.yaml", "scene/marble.glsl"; sorted.
    [[nodiscard]] std::vector<std::string> names() const;

    // Whether the text stands in any shader or code of the scene, but for lib/debug.glsl.
    [[nodiscard]] bool anyShaderHas(const std::string& text) const;

    // The file of that name; nothing where it is none that may be read.
    [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& name) const;
    // What the page calls a file; empty where it may not read it.
    [[nodiscard]] std::string nameOf(const std::filesystem::path& file) const;

private:
    std::filesystem::path shaders_; // canonical
    std::filesystem::path scene_;   // canonical
    std::vector<std::filesystem::path> code_;
};

} // namespace hyalite::live
