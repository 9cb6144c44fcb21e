// Compiled kernels on disk, found by a hash of everything they were compiled from. The cache only saves time: what it
// cannot read it does not have, what it cannot write it leaves.
#pragma once

#include "gpu/spirv.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hyalite::gpu {

class SpirvCache {
public:
    explicit SpirvCache(std::filesystem::path folder) : folder_(std::move(folder)) {} // empty: keeps nothing

    // Nothing when it is not there or damaged.
    [[nodiscard]] std::optional<SpirV> load(const std::string& key) const;
    void store(const std::string& key, const SpirV& spirv) const;

    // 32 hexadecimal digits that stand for every byte the result depends on.
    [[nodiscard]] static std::string key(std::string_view source);

private:
    std::filesystem::path folder_;
};

} // namespace hyalite::gpu
