// Choosing a light, a point on it, and what it sends to a surface.
#ifndef HYALITE_LIGHT_GLSL
#define HYALITE_LIGHT_GLSL
#include "shared/scene_records.h"
#include "lib/sampling.glsl"
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

struct LightPoint {
    vec3 position; // moved off the emitting side by what the rounding of its coordinates may be
    vec3 normal;   // unit; of no meaning on point lights
};

LightPoint pointOnSphere(LightRecord light, vec3 normal) {
    float radius = light.edge0.x;
    float error = kPositionError * (largestCoordinate(light.position) + radius);
    return LightPoint(light.position + (radius + error) * normal, normal);
}

// Evenly distributed over the light's area.
LightPoint pointOnLight(LightRecord light, vec2 u) {
    if (light.type == kLightPoint) {
        return LightPoint(light.position, vec3(0.0));
    }
    if (light.type == kLightSphere) {
        return pointOnSphere(light, uniformSphere(u));
    }
    vec2 at = light.type == kLightDisk ? concentricDisc(u) : u;
    vec3 p = light.position + at.x * light.edge0 + at.y * light.edge1;
    float error = kPlaneError * dot(abs(light.normal), abs(light.position) + abs(light.edge0) + abs(light.edge1));
    return LightPoint(p + error * light.normal, light.normal);
}

// Of a sphere only the half that faces the receiver: what is turned away cannot light it.
LightPoint pointFacing(LightRecord light, vec3 receiver, vec2 u) {
    if (light.type != kLightSphere) {
        return pointOnLight(light, u);
    }
    vec3 normal = uniformSphere(u);
    return pointOnSphere(light, dot(normal, receiver - light.position) < 0.0 ? -normal : normal);
}

// Irradiance-like weight [W/m^2 per unit cosine at the receiver] that the light sends from a point of pointFacing to a
// receiver at squared distance `distance2` in the unit direction `fromLight`; the pdf of the point is divided out.
vec3 arrivingFlux(LightRecord light, vec3 normal, vec3 fromLight, float distance2) {
    if (light.type == kLightPoint) {
        return light.emission / distance2;
    }
    float area = light.type == kLightSphere ? 0.5 * light.area : light.area;
    return light.emission * (max(0.0, dot(fromLight, normal)) * area / distance2);
}

// Density [1/sr] with which pointFacing takes a point that sends light in the unit direction `fromLight` over the
// squared distance, normal as there; 0 for point lights, which no ray meets.
float lightPdfW(LightRecord light, vec3 normal, vec3 fromLight, float distance2) {
    if (light.type == kLightPoint) {
        return 0.0;
    }
    float area = light.type == kLightSphere ? 0.5 * light.area : light.area;
    return distance2 / max(kTiny, dot(fromLight, normal) * area);
}
#endif
