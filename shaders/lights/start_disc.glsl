// The disc across the light's direction where photons of parallel light and of the environment start; it covers
// everything that the light must reach.
#ifndef HYALITE_START_DISC_GLSL
#define HYALITE_START_DISC_GLSL
#include "shared/scene_records.h"
#include "lib/sampling.glsl"

// Does the line through the point cross the disc?
bool passesDisc(LightRecord light, vec3 point, vec3 direction) {
    vec3 offset = point - light.position;
    offset -= dot(offset, direction) * direction;
    return dot(offset, offset) <= light.radius * light.radius;
}

// A uniform point on the disc across `direction` [m].
vec3 pointOnDisc(LightRecord light, vec3 direction, vec2 u) {
    vec3 onDisc = fromLocal(vec3(light.radius * concentricDisc(u), 0.0), direction);
    return light.position - light.distance * direction + onDisc;
}
#endif
