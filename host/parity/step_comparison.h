// One step of the device's path against the twin's, which goes on from the device's own ray: what the two got wrong
// before does not count.
#pragma once

#include "parity/sides.h"
#include "parity/twin_path.h"
#include "parity/vertex.h"

#include <optional>
#include <string>
#include <vector>

namespace hyalite::parity {

// Positions agree within this share of the scene's scale, directions within this length, throughput and flux within
// this share of themselves; those that leave a step, of what came to it if that is more.
inline constexpr double kPathTolerance = 1e-4;

// Why the step at `vertex` of `path`, or the start of what follows it there, differs from the twin's. None: it does
// not; empty: no few roundings of its ray explain the difference. `pass`: a photon path's.
[[nodiscard]] std::optional<std::string> causeOfDifference(const Sides& sides, const PathKey& key,
                                                           const reference::PhotonPass& pass,
                                                           const std::vector<DeviceVertex>& path,
                                                           const DeviceVertex& vertex);

} // namespace hyalite::parity
