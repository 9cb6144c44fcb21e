// Storage for photons as they land, bounce after bounce.
#pragma once

#include "render/wavefront/device.h"

#include "shaders/shared/limits.h"
#include "shaders/shared/path_records.h"

namespace hyalite::render {

// Makes room for this many photons and keeps the present ones; finishes the commands recorded so far if it must grow.
void reservePhotonSlots(Device& device, gpu::Array<shared::Photon>& photons, std::uint32_t slots);

// The stored photons among the first `slots`, compacted, in order. No command may be in flight.
[[nodiscard]] std::vector<shared::Photon> storedPhotons(const gpu::Array<shared::Photon>& photons, std::uint32_t slots);

} // namespace hyalite::render
