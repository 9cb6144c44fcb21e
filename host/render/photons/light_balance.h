// The account of photon tracing.
#pragma once

#include <glm/glm.hpp>

namespace hyalite::render {

// Where the flux that a light emitted went [W]: the last four add up to the first.
struct LightBalance {
    glm::dvec3 emitted{0};
    glm::dvec3 stored{0};   // left on diffuse surfaces where photons were stored
    glm::dvec3 absorbed{0}; // by mirrors, glass and absorbing surfaces
    glm::dvec3 escaped{0};  // out of the scene
    glm::dvec3 cutOff{0};   // would have been reflected at the end of the longest path
};

} // namespace hyalite::render
