// What a visible point makes of the light that comes to it from any direction: all that does not depend on the
// direction is evaluated once for a point.
#pragma once

#include "reference/bsdf/bsdf.h"
#include "reference/lights/lights.h"

#include <optional>

namespace hyalite::reference {

struct Receiver {
    glm::dvec3 f; // path throughput times the BSDF [1/sr], but for the factor of the direction of incidence
    std::optional<DiffusePart> diffuse; // none: that factor is 1

    // The factor of a direction of incidence, `cosine` from the normal, and its mean for light that comes evenly from
    // everywhere.
    [[nodiscard]] double incident(double cosine) const { return diffuse ? diffuse->letThrough(cosine) : 1; }
    [[nodiscard]] double meanIncident() const { return diffuse ? diffuse->meanLetThrough() : 1; }
};

[[nodiscard]] Receiver receiverAt(const VisiblePoint& x);

} // namespace hyalite::reference
