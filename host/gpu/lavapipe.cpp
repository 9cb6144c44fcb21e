#include "gpu/lavapipe.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string>
#include <thread>

namespace hyalite::gpu {
namespace {

constexpr std::uint32_t kMostThreads = 32; // LP_MAX_THREADS of Mesa 25

bool hasAvx512() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
           __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0;
#else
    return false;
#endif
}

// NOLINTBEGIN(concurrency-mt-unsafe): prepareLavapipe() is called while there is one thread, and nothing else sets
// variables

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string() : value;
}

} // namespace

void prepareLavapipe(const std::filesystem::path& cacheFolder) {
    std::string width = environment("LP_NATIVE_VECTOR_WIDTH");
    if (width.empty() && hasAvx512()) {
        width = "512";
        setenv("LP_NATIVE_VECTOR_WIDTH", width.c_str(), 1);
    }
    const std::string given = environment("MESA_SHADER_CACHE_DIR");
    std::filesystem::path folder = given.empty() ? cacheFolder : std::filesystem::path(given);
    if (folder.empty() || width.find_first_not_of("0123456789") != std::string::npos) {
        setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
        return;
    }
    folder /= "driver-width-" + (width.empty() ? "native" : width);
    std::error_code ignored; // the driver works without a cache
    std::filesystem::create_directories(folder, ignored);
    setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 1);
}

std::uint32_t lavapipeThreads() {
    const std::string given = environment("LP_NUM_THREADS");
    std::uint32_t threads = std::thread::hardware_concurrency();
    std::from_chars(given.data(), given.data() + given.size(), threads); // unchanged if the variable is not set
    return std::clamp(threads, 1U, kMostThreads);
}

// NOLINTEND(concurrency-mt-unsafe)

} // namespace hyalite::gpu
