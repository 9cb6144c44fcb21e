// Compiled kernels on disk, found by a hash of everything they were compiled from. The cache only saves time: entries
// that it cannot read count as missing, and a failed write is ignored.
#pragma once

#include "gpu/spirv.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hyalite::gpu {

class SpirvCache {
public:
    explicit SpirvCache(std::filesystem::path folder) : folder_(std::move(folder)) {} // empty: no cache

    // None if the entry is missing or corrupt.
    [[nodiscard]] std::optional<SpirV> load(const std::string& key) const;
    void store(const std::string& key, const SpirV& spirv) const;

    // 32 hexadecimal digits: a hash of every byte that the result depends on.
    [[nodiscard]] static std::string key(std::string_view source);

private:
    std::filesystem::path folder_;
};

} // namespace hyalite::gpu
