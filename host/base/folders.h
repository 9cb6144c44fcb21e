// Where files stand.
#pragma once

#include <algorithm>
#include <filesystem>

namespace hyalite {

// Whether the file is in the folder or below it (an empty one: the current folder). Symbolic links are followed first,
// so that none leads out; neither need exist.
[[nodiscard]] inline bool isInside(const std::filesystem::path& file, const std::filesystem::path& folder) {
    const std::filesystem::path path = std::filesystem::weakly_canonical(file);
    const std::filesystem::path root = std::filesystem::weakly_canonical(folder.empty() ? "." : folder);
    return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

} // namespace hyalite
