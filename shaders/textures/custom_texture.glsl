// Textures that scenes supply as GLSL (docs/experiments.md). For such a scene the host replaces this file with their
// source and a customTexture() that calls the function of that number.
#ifndef HYALITE_CUSTOM_TEXTURE_GLSL
#define HYALITE_CUSTOM_TEXTURE_GLSL
#include "lib/math.glsl"
#include "shared/random.h"

// Share of the light reflected at a world position [m] with surface coordinates uv.
vec3 customTexture(uint number, vec3 position, vec2 uv, vec4 parameters) {
    return vec3(0.0);
}
#endif
