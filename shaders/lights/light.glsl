// The list of lights: picking one, sampling the light it sends to a surface, and emitting rays into the scene
// [Jensen01, ch. 5]. Each type of light has its own file; only this file dispatches on the type. A kernel compiles only
// the types in the scene.
#ifndef HYALITE_LIGHT_GLSL
#define HYALITE_LIGHT_GLSL
#include "shared/scene_records.h"
#include "lights/area.glsl"
#include "lights/directional.glsl"
#include "lights/environment.glsl"
#include "lights/light_sample.glsl"
#include "lights/pick_light.glsl"
#include "lights/point.glsl"
#include "lights/spot.glsl"
#include "lib/sampling.glsl"

// As pickLight, with a number from the sampler if there is more than one light.
uint pickLight(LightArray lights, uint lightCount, Sampler s, uint dimension) {
    return lightCount > 1u ? pickLight(lights, lightCount, sampleUnit(s, dimension).x) : 0u;
}

// Has the light a surface?
bool isSurface(uint type) {
    return isLight(type, kLightQuad) || isLight(type, kLightDisk) || isLight(type, kLightSphere) || isLight(type, kLightMesh);
}

// Is its light parallel?
bool isParallel(uint type) {
    return isLight(type, kLightDirectional) || isLight(type, kLightBeam);
}

// ---- From a receiver to the light

// Density [1/sr] of sampleLight for the unit `direction` from a receiver that sees the light there, at this distance
// and with this normal (both ignored for light from beyond the scene); 0 for lights that no ray can hit. The light's
// pmf is not included.
float lightPdf(LightRecord light, vec3 receiver, vec3 direction, float distance, vec3 lightNormal) {
    if (isLight(light.type, kLightEnvironment)) {
        return environmentPdf(light, environmentRadiance(light, direction));
    }
    return isSurface(light.type) ? areaPdf(light, direction, distance, lightNormal) : 0.0;
}

LightSample sampleLight(LightRecord light, vec3 receiver, vec2 u) {
    if (isLight(light.type, kLightDirectional)) {
        return sampleDirectional(light);
    }
    if (isLight(light.type, kLightBeam)) {
        return sampleBeam(light, receiver);
    }
    if (isLight(light.type, kLightEnvironment)) {
        return sampleEnvironment(light, u);
    }
    if (isSurface(light.type)) {
        return sampleArea(light, receiver, u);
    }
    if (isLight(light.type, kLightSpot)) {
        return sampleSpot(light, receiver);
    }
    return samplePoint(light, receiver);
}

// Does an unoccluded ray see the front of a quad, disk or sphere?
bool looksAt(LightRecord light, vec3 origin, vec3 direction) {
    return isSurface(light.type) && looksAtArea(light, origin, direction);
}

bool looksAtAny(LightArray lights, uint count, vec3 origin, vec3 direction) {
    for (uint i = 0u; i < count; ++i) {
        if (looksAt(lights.at[i], origin, direction)) {
            return true;
        }
    }
    return false;
}

// ---- From the light into the scene

// Density [1/sr] of emitFrom for `direction`, from a point with this normal; 0 for directions it never samples, and for
// parallel light.
float emissionDensity(LightRecord light, vec3 normal, vec3 direction) {
    if (isSurface(light.type)) {
        return areaDensity(normal, direction);
    }
    if (isLight(light.type, kLightPoint)) {
        return pointDensity();
    }
    if (isLight(light.type, kLightSpot)) {
        return spotDensity(light, direction);
    }
    return isLight(light.type, kLightEnvironment) ? environmentPdf(light, environmentRadiance(light, -direction)) : 0.0;
}

// Density [1/m^2], across `direction`, with which emitFrom starts its rays of this direction on the line through
// `point`; 0 for lights that sample the origin first. For parallel light the direction must be the light's.
float originDensity(LightRecord light, vec3 point, vec3 direction) {
    bool hasDisc = isParallel(light.type) || isLight(light.type, kLightEnvironment);
    return hasDisc && passesDisc(light, point, direction) ? 1.0 / light.area : 0.0;
}

// 1 - cosine of the cone that contains all directions in which one point of the light emits.
float emissionExtent(LightRecord light) {
    return isLight(light.type, kLightSpot) ? light.cone.y : (isSurface(light.type) ? 1.0 : 2.0);
}

// A photon ray of the light, with density proportional to the flux.
LightRay emitFrom(LightRecord light, vec2 uOrigin, vec2 uDirection) {
    if (isLight(light.type, kLightEnvironment)) {
        return emitFromEnvironment(light, uOrigin, uDirection);
    }
    if (isParallel(light.type)) {
        return emitParallel(light, uOrigin);
    }
    if (isSurface(light.type)) {
        return emitFromArea(light, uOrigin, uDirection);
    }
    if (isLight(light.type, kLightSpot)) {
        return emitFromSpot(light, uDirection);
    }
    return emitFromPoint(light, uDirection);
}
#endif
