// The list of lights: choosing one, what it sends to a surface, and what it sends into the scene [Jensen01, ch. 5]. Each
// type of light has a file; this one alone asks for the type. A kernel holds only the types that the scene has.
#ifndef HYALITE_LIGHT_GLSL
#define HYALITE_LIGHT_GLSL
#include "shared/scene_records.h"
#include "lights/area.glsl"
#include "lights/directional.glsl"
#include "lights/environment.glsl"
#include "lights/light_sample.glsl"
#include "lights/point.glsl"
#include "lights/spot.glsl"
#include "lib/sampling.glsl"

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

// The same, with a number of the sampler's if there is a choice.
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

// Density [1/sr] with which sampleLight chooses the unit `direction` from a receiver that sees the light there, at this
// distance and with this normal (neither matters where it comes from beyond the scene); 0 where it chooses none, at
// lights that no ray can hit. The light's pmf is not in it.
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

// Does a ray that nothing stops see the front of a quad, a disk or a sphere?
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

// Density [1/sr] with which emitFrom would send `direction` from a point with this normal; 0 where it never would, and
// for parallel light.
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
// `point`; 0 for lights that choose the origin first. Of parallel light the direction must be its own.
float originDensity(LightRecord light, vec3 point, vec3 direction) {
    bool hasDisc = isParallel(light.type) || isLight(light.type, kLightEnvironment);
    return hasDisc && passesDisc(light, point, direction) ? 1.0 / light.area : 0.0;
}

// 1 - cosine of the cone that holds all directions of the light from one of its points.
float emissionExtent(LightRecord light) {
    return isLight(light.type, kLightSpot) ? light.cone.y : (isSurface(light.type) ? 1.0 : 2.0);
}

// A ray of the light's photons, whose density is in proportion to the flux.
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
