// One file per kernel: a header with sizes and checksum, then the SPIR-V words.
#include "gpu/spirv_cache.h"

#include "base/fnv.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <span>
#include <system_error>
#include <unistd.h>

namespace hyalite::gpu {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kSpirvMagic = 0x07230203;

struct Header {
    std::array<char, 8> magic = {'h', 'y', 's', 'p', 'i', 'r', 'v', '1'};
    std::uint64_t words = 0;
    std::uint64_t checksum = 0;
};

std::span<const char> asChars(const SpirV& spirv) {
    return {reinterpret_cast<const char*>(spirv.data()), spirv.size() * sizeof(SpirV::value_type)};
}

// A file name that no other writer uses: other threads and processes may compile the same kernel.
fs::path temporaryName(const fs::path& file) {
    static std::atomic<unsigned> count = 0;
    return file.string() + '.' + std::to_string(getpid()) + '.' + std::to_string(count++);
}

} // namespace

std::string SpirvCache::key(std::string_view source) {
    // Two 64-bit states, 128 bits: a collision by chance is practically impossible.
    const auto bytes = std::as_bytes(std::span(source));
    std::array<char, 33> text{};
    std::snprintf(text.data(), text.size(), "%016llx%016llx", static_cast<unsigned long long>(fnv(bytes)),
                  static_cast<unsigned long long>(fnv(bytes, 0x9e3779b97f4a7c15U)));
    return text.data();
}

std::optional<SpirV> SpirvCache::load(const std::string& key) const {
    if (folder_.empty()) {
        return std::nullopt;
    }
    std::ifstream stream(folder_ / (key + ".spv"), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    Header header;
    if (!stream.is_open() || bytes.size() < sizeof(Header)) {
        return std::nullopt;
    }
    std::copy_n(bytes.data(), sizeof(Header), reinterpret_cast<char*>(&header));
    const std::size_t payload = bytes.size() - sizeof(Header);
    SpirV spirv(payload / sizeof(SpirV::value_type));
    std::copy_n(bytes.data() + sizeof(Header), spirv.size() * sizeof(SpirV::value_type),
                reinterpret_cast<char*>(spirv.data()));
    const bool sound = header.magic == Header().magic && payload == header.words * sizeof(SpirV::value_type) &&
                       header.checksum == fnv(std::as_bytes(std::span(spirv))) && !spirv.empty() &&
                       spirv[0] == kSpirvMagic;
    return sound ? std::optional(std::move(spirv)) : std::nullopt;
}

void SpirvCache::store(const std::string& key, const SpirV& spirv) const {
    if (folder_.empty()) {
        return;
    }
    std::error_code error; // a cache that cannot be written only makes the next start slower
    fs::create_directories(folder_, error);
    const fs::path file = folder_ / (key + ".spv");
    const fs::path temporary = temporaryName(file);
    const Header header{.words = spirv.size(), .checksum = fnv(std::as_bytes(std::span(spirv)))};
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(&header), sizeof(header));
    stream.write(asChars(spirv).data(), std::streamsize(asChars(spirv).size()));
    stream.close();
    if (stream) {
        fs::rename(temporary, file, error);
    }
    if (!stream || error) {
        fs::remove(temporary, error);
    }
}

} // namespace hyalite::gpu
