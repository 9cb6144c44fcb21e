// Reflection of incident light at a visible point: the factors that do not depend on the direction of incidence are
// evaluated once per point.
#pragma once

#include "reference/bsdf/bsdf.h"
#include "reference/lights/lights.h"

#include <optional>

namespace hyalite::reference {

struct Receiver {
    glm::dvec3 f; // path throughput times the BSDF [1/sr], without the factor of the direction of incidence
    std::optional<DiffusePart> diffuse; // none: that factor is 1

    // The factor for a direction of incidence at `cosine` to the normal, and its mean under uniform illumination.
    [[nodiscard]] double incident(double cosine) const { return diffuse ? diffuse->letThrough(cosine) : 1; }
    [[nodiscard]] double meanIncident() const { return diffuse ? diffuse->meanLetThrough() : 1; }
};

[[nodiscard]] Receiver receiverAt(const VisiblePoint& x);

} // namespace hyalite::reference
