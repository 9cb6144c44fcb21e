// Photon maps in a file, with the identity of the render that they were traced for.
#pragma once

#include "render/film/render_identity.h"

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

// `identity`: what the photons depend on (see identifyPhotons). Throws Error(OutputNotWritten).
void writePhotons(const std::filesystem::path& path, const PhotonLists& lists, const RenderIdentity& identity);

// Throws Error(BadInput) for what is no photon file, is damaged, or has another identity; then it names the difference.
[[nodiscard]] PhotonLists readPhotons(const std::filesystem::path& path, const RenderIdentity& identity);

// The same of a file's content; `path` is for messages.
[[nodiscard]] PhotonLists parsePhotons(std::span<const std::byte> file, const std::filesystem::path& path,
                                       const RenderIdentity& identity);

} // namespace hyalite::render
