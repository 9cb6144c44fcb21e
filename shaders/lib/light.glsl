// Choosing a light, a point on it, and what it sends to a surface.
#ifndef HYALITE_LIGHT_GLSL
#define HYALITE_LIGHT_GLSL
#include "shared/scene_records.h"
#include "lib/surface.glsl"

// The first light whose cdf exceeds x in [0, 1): light i with probability pmf_i.
uint pickLight(LightArray lights, uint lightCount, float x) {
    uint first = 0u, last = lightCount - 1u;
    while (first < last) {
        uint middle = (first + last) / 2u;
        if (x < lights.at[middle].cdf) {
            last = middle;
        } else {
            first = middle + 1u;
        }
    }
    return first;
}

// A point on the light, moved off its emitting side by what the rounding of its coordinates may be.
vec3 pointOnLight(LightRecord light, vec2 u) {
    if (light.type == kLightPoint) {
        return light.position;
    }
    vec3 p = light.position + u.x * light.edge0 + u.y * light.edge1;
    float error = kPlaneError * dot(abs(light.normal), abs(light.position) + abs(light.edge0) + abs(light.edge1));
    return p + error * light.normal;
}

// Irradiance-like weight [W/m^2 per unit cosine at the receiver] that the light sends from the point to a receiver at
// squared distance `distance2` in the unit direction `fromLight`; the pdf of the point is divided out.
vec3 arrivingFlux(LightRecord light, vec3 fromLight, float distance2) {
    if (light.type == kLightPoint) {
        return light.emission / distance2;
    }
    return light.emission * (max(0.0, dot(fromLight, light.normal)) * light.area / distance2);
}
#endif
