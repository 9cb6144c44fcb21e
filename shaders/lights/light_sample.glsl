// The samples that every light provides: a direction from a receiver to the light, and a ray from the light into the
// scene.
#ifndef HYALITE_LIGHT_SAMPLE_GLSL
#define HYALITE_LIGHT_SAMPLE_GLSL
#include "lib/math.glsl"

// One direction from a receiver to a light.
struct LightSample {
    vec3 direction;       // unit, towards the light
    vec3 irradiance;      // on a surface that faces the direction [W/m^2], the direction's density divided out
    float pdfW;           // that density [1/sr]; 0: the direction is discrete, and no ray can hit the light
    vec3 shadowDirection; // unit, to the shadow ray's end: just off the light
    float shadowDistance; // [m]; kInfinity: beyond the scene
};

// How a photon leaves a light. The density of the whole ray is that of the origin times that of the direction given the
// origin; for parallel light and light from beyond the scene, that of the direction times that of the origin given the
// direction.
struct LightRay {
    vec3 origin;        // world, on the light [m]
    vec3 direction;     // unit
    vec3 normal;        // unit, of the light at the origin; zero where it has no surface
    float error;        // the ray starts this far off the light, along the normal [m]
    vec3 power;         // flux [W] of the light if all its photons were like this one
    float pdfDirection; // [1/sr], given the origin; 0: the direction was sampled first
    float pdfOrigin;    // [1/m^2] across the direction, given the direction; 0: the origin was sampled first
};

// Start of the ray [m].
vec3 startOf(LightRay ray) {
    return ray.origin + ray.error * ray.normal;
}
#endif
