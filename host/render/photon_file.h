// Photon maps in a file, with a fingerprint of what they were traced for.
#pragma once

#include "render/device_scene.h"

#include "shaders/shared/path_records.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace hyalite::render {

// The photons of the maps of photon mapping as they were stored, without gaps.
struct PhotonLists {
    std::vector<shared::Photon> global;
    std::vector<shared::Photon> caustic;
    std::vector<shared::Photon> shadow;
};

// A number that changes with everything the photons depend on: the scene as the device sees it, without the camera, and
// the settings that photons are traced by.
[[nodiscard]] std::uint64_t photonFingerprint(const Scene& scene, const DeviceScene& deviceScene);

// Throws Error(OutputNotWritten).
void writePhotons(const std::filesystem::path& path, const PhotonLists& lists, std::uint64_t fingerprint);

// Throws Error(BadInput) for what is no photon file, is damaged, or has another fingerprint.
[[nodiscard]] PhotonLists readPhotons(const std::filesystem::path& path, std::uint64_t fingerprint);

} // namespace hyalite::render
