// Room for photons as they land, bounce after bounce.
#pragma once

#include "render/wavefront/device.h"

#include "shaders/shared/limits.h"
#include "shaders/shared/path_records.h"

namespace hyalite::render {

// Makes room for so many photons and keeps those that are there; finishes the commands recorded so far if it must.
void reservePhotonSlots(Device& device, gpu::Array<shared::Photon>& photons, std::uint32_t slots);

// The stored photons among the first `slots`, without the gaps, in order. No command may be in flight.
[[nodiscard]] std::vector<shared::Photon> storedPhotons(const gpu::Array<shared::Photon>& photons, std::uint32_t slots);

} // namespace hyalite::render
