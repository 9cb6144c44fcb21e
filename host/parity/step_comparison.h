// Compares one step of the device's path with the twin's step from the device's own ray, so that earlier differences do
// not count.
#pragma once

#include "parity/sides.h"
#include "parity/twin_path.h"
#include "parity/vertex.h"

#include <optional>
#include <string>
#include <vector>

namespace hyalite::parity {

// Positions agree within this fraction of the scene's scale, directions within this length, throughput and flux within
// this fraction of themselves; for those leaving a step, of what arrived if that is more.
inline constexpr double kPathTolerance = 1e-4;

// Why the step at `vertex` of `path`, or the start of a ray that follows, differs from the twin's. None: it does not
// differ; empty: roundings of its ray do not explain the difference. `pass`: for photon paths.
[[nodiscard]] std::optional<std::string> causeOfDifference(const Sides& sides, const PathKey& key,
                                                           const reference::PhotonPass& pass,
                                                           const std::vector<DeviceVertex>& path,
                                                           const DeviceVertex& vertex);

} // namespace hyalite::parity
