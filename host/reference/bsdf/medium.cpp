// See medium.h.
#include "reference/bsdf/medium.h"

#include <glm/exponential.hpp>

namespace hyalite::reference {

glm::dvec3 transmittance(const Material* medium, double distance) {
    const auto* dielectric = medium != nullptr ? std::get_if<Dielectric>(&medium->model) : nullptr;
    return dielectric != nullptr ? glm::exp(-dielectric->absorption * distance) : glm::dvec3(1);
}

} // namespace hyalite::reference
