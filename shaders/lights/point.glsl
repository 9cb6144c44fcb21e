// Light from a point, the same in every direction.
#ifndef HYALITE_POINT_GLSL
#define HYALITE_POINT_GLSL
#include "shared/scene_records.h"
#include "lib/sampling.glsl"
#include "lights/light_sample.glsl"

LightSample samplePoint(LightRecord light, vec3 receiver) {
    vec3 toLight = light.position - receiver;
    float distance2 = dot(toLight, toLight);
    float distance = sqrt(distance2);
    return LightSample(toLight / distance, light.emission * (1.0 / distance2), 0.0, toLight / distance, distance);
}

// Density [1/sr] of emitFromPoint.
float pointDensity() {
    return 0.25 * kInvPi;
}

LightRay emitFromPoint(LightRecord light, vec2 uDirection) {
    return LightRay(light.position, uniformSphere(uDirection), vec3(0.0), 0.0, light.power, pointDensity(), 0.0);
}
#endif
