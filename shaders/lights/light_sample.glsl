// What every light gives: one direction from a receiver to it, and one ray from it into the scene.
#ifndef HYALITE_LIGHT_SAMPLE_GLSL
#define HYALITE_LIGHT_SAMPLE_GLSL
#include "lib/math.glsl"

// One direction from a receiver to a light.
struct LightSample {
    vec3 direction;       // unit, towards the light
    vec3 irradiance;      // on a surface that faces the direction [W/m^2], the direction's density divided out
    float pdfW;           // that density [1/sr]; 0: there was no choice, and no ray can hit the light
    vec3 shadowDirection; // unit, to where a shadow ray ends: just off the light
    float shadowDistance; // [m]; kInfinity: beyond the scene
};

// How a photon leaves a light. The density of the whole ray is that of the origin times that of the direction given the
// origin; where light is parallel or comes from beyond the scene, of the direction times that of the origin.
struct LightRay {
    vec3 origin;        // world, on the light [m]
    vec3 direction;     // unit
    vec3 normal;        // unit, of the light at the origin; zero where it has no surface
    float error;        // along the normal: the ray starts so far off the light [m]
    vec3 power;         // flux [W] of the light if all its photons were like this one
    float pdfDirection; // [1/sr], given the origin; 0: the origin was chosen for the direction
    float pdfOrigin;    // [1/m^2] across the direction and given it; 0: the direction was chosen for the origin
};

// Where a ray of the light's starts [m].
vec3 startOf(LightRay ray) {
    return ray.origin + ray.error * ray.normal;
}
#endif
