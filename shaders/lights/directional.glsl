// Parallel light: from beyond the scene onto all of it, or a beam that starts at a disc and is as wide as the disc.
#ifndef HYALITE_DIRECTIONAL_GLSL
#define HYALITE_DIRECTIONAL_GLSL
#include "shared/scene_records.h"
#include "lights/light_sample.glsl"
#include "lights/start_disc.glsl"

LightSample sampleDirectional(LightRecord light) {
    return LightSample(-light.normal, light.emission, 0.0, -light.normal, kInfinity);
}

LightSample sampleBeam(LightRecord light, vec3 receiver) {
    float along = dot(receiver - light.position, light.normal);
    bool isLit = along > 0.0 && passesDisc(light, receiver, light.normal);
    return LightSample(-light.normal, isLit ? light.emission : vec3(0.0), 0.0, -light.normal, along);
}

LightRay emitParallel(LightRecord light, vec2 uOrigin) {
    return LightRay(pointOnDisc(light, light.normal, uOrigin), light.normal, vec3(0.0), 0.0, light.power, 0.0,
                    1.0 / light.area);
}
#endif
