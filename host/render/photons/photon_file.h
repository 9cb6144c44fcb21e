// Photon maps in a file, with a fingerprint of what they were traced for (see scene_identity.h).
#pragma once

#include "shaders/shared/path_records.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace hyalite::render {

// The photons of the maps of photon mapping as they were stored, without gaps.
struct PhotonLists {
    std::vector<shared::Photon> global;
    std::vector<shared::Photon> caustic;
    std::vector<shared::Photon> shadow;
};

// Throws Error(OutputNotWritten).
void writePhotons(const std::filesystem::path& path, const PhotonLists& lists, std::uint64_t fingerprint);

// Throws Error(BadInput) for what is no photon file, is damaged, or has another fingerprint.
[[nodiscard]] PhotonLists readPhotons(const std::filesystem::path& path, std::uint64_t fingerprint);

// The same of a file's content; `path` is for messages.
[[nodiscard]] PhotonLists parsePhotons(std::span<const std::byte> file, const std::filesystem::path& path,
                                       std::uint64_t fingerprint);

} // namespace hyalite::render
