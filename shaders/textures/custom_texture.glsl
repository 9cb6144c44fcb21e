// Textures that scenes bring along as GLSL (docs/experiments.md). For a scene that has some, the host puts in place of this
// file their source, and a customTexture() that calls the one of that number.
#ifndef HYALITE_CUSTOM_TEXTURE_GLSL
#define HYALITE_CUSTOM_TEXTURE_GLSL
#include "lib/math.glsl"
#include "shared/random.h"

// Share of the light reflected at a point of the world [m] with the surface coordinates uv.
vec3 customTexture(uint number, vec3 position, vec2 uv, vec4 parameters) {
    return vec3(0.0);
}
#endif
