// Materials that scenes supply as GLSL (docs/experiments.md). For such a scene the host replaces this file with their
// source and a customReflectance() that calls the function of that number.
#ifndef HYALITE_CUSTOM_REFLECTANCE_GLSL
#define HYALITE_CUSTOM_REFLECTANCE_GLSL
#include "lib/math.glsl"
#include "shared/random.h"

// Share of the light that a facet reflects; cosine: of the angle between the light and the facet's normal.
vec3 customReflectance(uint number, float cosine, vec4 parameters) {
    return vec3(0.0);
}
#endif
