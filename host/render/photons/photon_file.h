// Photon maps in a file, with the identity of the render that traced them.
#pragma once

#include "render/film/render_identity.h"

#include "shaders/shared/path_records.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace hyalite::render {

// The stored photons of each map, compacted.
struct PhotonLists {
    std::vector<shared::Photon> global;
    std::vector<shared::Photon> caustic;
    std::vector<shared::Photon> shadow;
};

// `identity`: what the photons depend on (see identifyPhotons). Throws Error(OutputNotWritten).
void writePhotons(const std::filesystem::path& path, const PhotonLists& lists, const RenderIdentity& identity);

// Throws Error(BadInput) if the file is not a photon file, is corrupt, or has a different identity; the message then
// names the difference.
[[nodiscard]] PhotonLists readPhotons(const std::filesystem::path& path, const RenderIdentity& identity);

// The same for a file's content; `path` is used in messages.
[[nodiscard]] PhotonLists parsePhotons(std::span<const std::byte> file, const std::filesystem::path& path,
                                       const RenderIdentity& identity);

} // namespace hyalite::render
