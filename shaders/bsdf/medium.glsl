// Absorption inside dielectrics.
#ifndef HYALITE_MEDIUM_GLSL
#define HYALITE_MEDIUM_GLSL
#include "shared/limits.h"
#include "shared/scene_records.h"
#include "lib/math.glsl"

// Share of the light left after a distance [m] in a material (kNone: no material): e^(-sigma t), the Beer-Lambert law.
vec3 transmittance(MaterialArray materials, uint medium, float distance) {
    if (medium == kNone) {
        return vec3(1.0);
    }
    vec3 depth = materials.at[medium].absorption * distance;
    return vec3(exponential(-depth.x), exponential(-depth.y), exponential(-depth.z));
}
#endif
