#include "cli/shader_folder.h"

#include "base/error.h"

#include <cstdlib>

namespace hyalite::cli {

namespace {

bool holdsShaders(const std::filesystem::path& folder) {
    std::error_code ignored;
    return std::filesystem::is_directory(folder / "kernels", ignored) &&
           std::filesystem::is_directory(folder / "shared", ignored);
}

// The folder share/hyalite next to the folder of the program.
std::filesystem::path installedFolder() {
    std::error_code ignored; // on failure the result names no existing folder
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    return program.parent_path().parent_path() / "share/hyalite";
}

} // namespace

std::filesystem::path findShaders(const std::string& given) {
    if (!given.empty()) {
        if (!holdsShaders(given)) {
            throw Error(ExitCode::WrongUsage, given + " is not a folder of shaders",
                        "it must contain the folders kernels, lib and shared");
        }
        return given;
    }
    std::filesystem::path installed = installedFolder() / "shaders";
    if (holdsShaders(installed)) {
        return installed;
    }
    if (holdsShaders(HYALITE_SHADER_DIR)) {
        return HYALITE_SHADER_DIR;
    }
    throw Error(ExitCode::WrongUsage,
                "no folder of shaders found: neither " + installed.string() + " nor " + HYALITE_SHADER_DIR + " is one",
                "give it with --shaders DIR");
}

std::filesystem::path shippedKernels() {
    std::error_code ignored;
    const std::filesystem::path installed = installedFolder() / "spirv";
    return std::filesystem::is_directory(installed, ignored) ? installed : std::filesystem::path(HYALITE_SPIRV_DIR);
}

reference::TwinSources twinSources(const std::vector<std::string>& given) {
    std::error_code ignored;
    const std::filesystem::path installed = installedFolder() / "twins";
    return {.files = {given.begin(), given.end()},
            .folder = std::filesystem::is_directory(installed, ignored) ? installed : HYALITE_TWIN_DIR};
}

// NOLINTBEGIN(concurrency-mt-unsafe): nobody sets them
std::filesystem::path cacheFolder() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != '\0') {
        return std::filesystem::path(cache) / "hyalite";
    }
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        return std::filesystem::path(home) / ".cache/hyalite";
    }
    return {};
}
// NOLINTEND(concurrency-mt-unsafe)

} // namespace hyalite::cli
