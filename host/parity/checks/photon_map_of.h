// Photons and visible points of the kernels that look up photons, in the reference's form.
#pragma once

#include "parity/check.h"
#include "parity/checks/visible_points.h"
#include "reference/photons/photon_map.h"

#include "shaders/shared/scene_records.h"

#include <vector>

namespace hyalite::parity {

// The photons of the table, in the reference's form.
[[nodiscard]] inline reference::PhotonMap mapOf(const Stage& stage, std::size_t first, std::size_t count) {
    std::vector<reference::Photon> photons;
    for (const shared::Photon& photon : stage.seen.table<shared::Photon>(TABLE_PHOTONS, first, count)) {
        photons.push_back(stage.sides.toTwin(photon));
    }
    return reference::PhotonMap(std::move(photons));
}

[[nodiscard]] inline reference::VisiblePoint nudged(const Stage& stage, const shared::VisiblePoint& point,
                                                    Nudge& nudge) {
    reference::VisiblePoint x = stage.sides.toTwin(point, nudge);
    x.position = nudge.point(x.position, stage.sides.scale());
    x.normal = nudge.direction(x.normal);
    return x;
}

} // namespace hyalite::parity
