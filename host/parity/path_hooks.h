// What following paths needs to know of an integrator.
#pragma once

#include "scene/model/scene.h"

namespace hyalite::parity {

struct PathHooks {
    bool bouncesAtDiffuse = false;     // camera paths go on from diffuse surfaces
    bool photonsAreTracedOnce = false; // those of pass 0 serve all passes
    // Changes settings that no path depends on, so that a pass for its paths takes no longer than they do. nullptr:
    // there are none.
    void (*simplify)(RenderSettings& render) = nullptr;
};

[[nodiscard]] PathHooks hooksOf(Integrator integrator);

} // namespace hyalite::parity
