// Materials that scenes bring along as GLSL (docs/experiments.md). For a scene that has some, the host puts in place of this
// file their source, and a customReflectance() that calls the one of that number.
#ifndef HYALITE_CUSTOM_REFLECTANCE_GLSL
#define HYALITE_CUSTOM_REFLECTANCE_GLSL
#include "lib/math.glsl"
#include "shared/random.h"

// Share of the light that a facet reflects; cosine: of the angle between the light and the facet's normal.
vec3 customReflectance(uint number, float cosine, vec4 parameters) {
    return vec3(0.0);
}
#endif
