// Visible points as kernel inputs.
#pragma once

#include "parity/comparison.h"

#include "shaders/shared/path_records.h"

#include <string>

namespace hyalite::parity {

// Description, for a report, of the point that an element was computed from.
[[nodiscard]] inline OffenderInputs visibleInputs(const shared::VisiblePoint& x) {
    return {{"position", describe(glm::dvec3(x.position))},
            {"normal", describe(glm::dvec3(x.normal))},
            {"wo", describe(glm::dvec3(x.wo))},
            {"beta", describe(glm::dvec3(x.beta))},
            {"material", std::to_string(x.material)},
            {"depth", std::to_string(x.depth)},
            {"pixel", std::to_string(x.pixel)}};
}

} // namespace hyalite::parity
