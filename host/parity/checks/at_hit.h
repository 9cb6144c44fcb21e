// Common comparison of what kernels do with paths at surfaces, for camera paths and photons.
#pragma once

#include "parity/check.h"

#include <optional>
#include <string>

namespace hyalite::parity {

// Compares the kernel's result for path i at its hit. `Kernel` holds the dispatch (stage, args, rays, hits) and both
// sides' answers; `own` lists the other inputs of the path.
template <class Kernel>
void compareAtHit(const Kernel& kernel, std::size_t i, const Comparison::Inputs& own) {
    const Sides& sides = kernel.stage.sides;
    const auto& deviceRay = kernel.rays[i];
    const reference::Ray ray = sides.toTwin(deviceRay);
    const auto hit = sides.refined(ray, deviceRay.from, kernel.hits[i]);
    std::optional<reference::Surface> surface;
    if (hit) {
        surface = reference::evaluateSurface(sides.world(), ray, *hit);
    }
    kernel.stage.compare(
        i, kernel.deviceAnswer(i, surface ? &*surface : nullptr, hit && hit->leaf != reference::kNoLeaf),
        [&](Nudge nudge) { return kernel.twinAnswer(i, hit, nudge); },
        [&] {
            OffenderInputs inputs = own();
            inputs.insert(
                inputs.end(),
                {{"depth", std::to_string(kernel.args.depth)},
                 {"origin", describe(glm::dvec3(deviceRay.origin))},
                 {"direction", describe(glm::dvec3(deviceRay.direction))},
                 {"hit", hit ? "object " + std::to_string(hit->object) + " at t = " + describe(hit->t) : "nothing"}});
            return inputs;
        });
}

} // namespace hyalite::parity
