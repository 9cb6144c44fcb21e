// See medium.h.
#include "reference/bsdf/medium.h"

#include <glm/exponential.hpp>

namespace hyalite::reference {

glm::dvec3 transmittance(const Material* medium, double distance) {
    return medium != nullptr ? glm::exp(-medium->model.absorption * distance) : glm::dvec3(1);
}

} // namespace hyalite::reference
