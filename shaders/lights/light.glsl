// Choosing a light, what it sends to a surface, and what it sends into the scene [Jensen01, ch. 5].
#ifndef HYALITE_LIGHT_GLSL
#define HYALITE_LIGHT_GLSL
#include "shared/scene_records.h"
#include "lights/environment.glsl"
#include "lib/sampling.glsl"
#include "lights/spot.glsl"
#include "shapes/surface.glsl"

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

// Has the light a surface, which emits on its front as much in every direction?
bool isSurface(uint type) {
    return isLight(type, kLightQuad) || isLight(type, kLightDisk) || isLight(type, kLightSphere) || isLight(type, kLightMesh);
}

// Does its light come from beyond the scene?
bool isEndless(uint type) {
    return isLight(type, kLightDirectional) || isLight(type, kLightEnvironment);
}

struct LightPoint {
    vec3 position;
    vec3 normal; // unit; zero of lights without a surface
    float error; // what the rounding of its coordinates may be [m]: rays start so far off the emitting side
};

LightPoint pointOnSphere(LightRecord light, vec3 normal) {
    float error = kPositionError * (largestCoordinate(light.position) + light.radius);
    return LightPoint(light.position + light.radius * normal, normal, error);
}

LightPoint pointOnMesh(LightRecord light, vec2 u) {
    Choice choice = choose(light.cdfs, 0u, light.columns, u.x);
    LightTriangle triangle = light.triangles.at[choice.index];
    // The square, shrunk to a corner along one side: its density is uniform if the other side goes as a square root
    float across = sqrt(choice.rest);
    vec3 p = triangle.corner + across * ((1.0 - u.y) * triangle.edge0 + u.y * triangle.edge1);
    return LightPoint(p, triangle.normal, light.error);
}

// Evenly distributed over the light's area; the place of a light without a surface.
LightPoint pointOnLight(LightRecord light, vec2 u) {
    if (!isSurface(light.type)) {
        return LightPoint(light.position, vec3(0.0), 0.0);
    }
    if (isLight(light.type, kLightSphere)) {
        return pointOnSphere(light, uniformSphere(u));
    }
    if (isLight(light.type, kLightMesh)) {
        return pointOnMesh(light, u);
    }
    vec2 at = isLight(light.type, kLightDisk) ? concentricDisc(u) : u;
    vec3 p = light.position + at.x * light.edge0 + at.y * light.edge1;
    float error = kPlaneError * dot(abs(light.normal), abs(light.position) + abs(light.edge0) + abs(light.edge1));
    return LightPoint(p, light.normal, error);
}

// Of a sphere only the half that faces the receiver: what is turned away cannot light it.
LightPoint pointFacing(LightRecord light, vec3 receiver, vec2 u) {
    if (!isLight(light.type, kLightSphere)) {
        return pointOnLight(light, u);
    }
    vec3 normal = uniformSphere(u);
    return pointOnSphere(light, dot(normal, receiver - light.position) < 0.0 ? -normal : normal);
}

// Area that pointFacing chooses from.
float areaFacing(LightRecord light) {
    return isLight(light.type, kLightSphere) ? 0.5 * light.area : light.area;
}

// Does the line through a point pass the disc where the light's photons start? Of lights that have one.
bool passesDisc(LightRecord light, vec3 point, vec3 direction) {
    vec3 offset = point - light.position;
    offset -= dot(offset, direction) * direction;
    return dot(offset, offset) <= light.radius * light.radius;
}

// Does a ray that nothing stops see the front of a quad, a disk or a sphere?
bool looksAt(LightRecord light, vec3 origin, vec3 direction) {
    vec3 toLight = light.position - origin;
    if (isLight(light.type, kLightSphere)) {
        return dot(toLight, direction) > 0.0 && passesDisc(light, origin, direction);
    }
    float away = dot(light.normal, direction);
    bool isFlat = isLight(light.type, kLightQuad) || isLight(light.type, kLightDisk);
    if (!isFlat || away >= 0.0 || dot(light.normal, toLight) >= 0.0) {
        return false;
    }
    vec3 p = (dot(light.normal, toLight) / away) * direction - toLight; // = at.x edge0 + at.y edge1
    vec3 across = cross(light.edge0, light.edge1);
    vec2 at = vec2(dot(cross(p, light.edge1), across), dot(cross(light.edge0, p), across)) / dot(across, across);
    return isLight(light.type, kLightQuad) ? all(greaterThanEqual(at, vec2(0.0))) && all(lessThanEqual(at, vec2(1.0)))
                                    : dot(at, at) <= 1.0;
}

bool looksAtAny(LightArray lights, uint count, vec3 origin, vec3 direction) {
    for (uint i = 0u; i < count; ++i) {
        if (looksAt(lights.at[i], origin, direction)) {
            return true;
        }
    }
    return false;
}

// ---- From a receiver to the light

// One direction from a receiver to a light.
struct LightSample {
    vec3 direction;       // unit, towards the light
    vec3 irradiance;      // on a surface that faces the direction [W/m^2], the direction's density divided out
    float pdfW;           // that density [1/sr]; 0: there was no choice, and no ray can hit the light
    vec3 shadowDirection; // unit, to where a shadow ray ends: just off the light
    float shadowDistance; // [m]; kInfinity: beyond the scene
};

// Density [1/sr] with which sampleLight chooses the unit `direction` from a receiver that sees the light there, at this
// distance and with this normal (neither matters where it comes from beyond the scene); 0 where it chooses none, at
// lights that no ray can hit. The light's pmf is not in it.
float lightPdf(LightRecord light, vec3 receiver, vec3 direction, float distance, vec3 lightNormal) {
    if (isLight(light.type, kLightEnvironment)) {
        return environmentPdf(light, environmentRadiance(light, direction));
    }
    float cosLight = -dot(direction, lightNormal);
    return isSurface(light.type) && cosLight > 0.0 ? distance * distance / (cosLight * areaFacing(light)) : 0.0;
}

LightSample sampleLight(LightRecord light, vec3 receiver, vec2 u) {
    if (isLight(light.type, kLightDirectional)) {
        return LightSample(-light.normal, light.emission, 0.0, -light.normal, kInfinity);
    }
    if (isLight(light.type, kLightBeam)) {
        float along = dot(receiver - light.position, light.normal);
        bool isLit = along > 0.0 && passesDisc(light, receiver, light.normal);
        return LightSample(-light.normal, isLit ? light.emission : vec3(0.0), 0.0, -light.normal, along);
    }
    if (isLight(light.type, kLightEnvironment)) {
        vec3 direction = sampleEnvironment(light, u);
        vec3 radiance = environmentRadiance(light, direction);
        float pdfW = environmentPdf(light, radiance);
        return LightSample(direction, pdfW > 0.0 ? radiance / pdfW : vec3(0.0), pdfW, direction, kInfinity);
    }
    LightPoint point = pointFacing(light, receiver, u);
    vec3 toLight = point.position - receiver;
    float distance2 = dot(toLight, toLight);
    float distance = sqrt(distance2);
    vec3 direction = toLight / distance;
    if (!isSurface(light.type)) {
        float share = isLight(light.type, kLightSpot) ? spotFalloff(light, -direction) : 1.0;
        return LightSample(direction, light.emission * (share / distance2), 0.0, direction, distance);
    }
    // Where the ray meets the light is also as wrong as roundings of the way there are, however small the light's own
    // coordinates: the ray ends that much before
    vec3 toEnd = toLight + (point.error + kPlaneError * distance) * point.normal;
    float shadowDistance = length(toEnd);
    vec3 shadowDirection = toEnd / shadowDistance;
    float cosLight = max(0.0, -dot(direction, point.normal));
    return LightSample(direction, light.emission * (cosLight * areaFacing(light) / distance2),
                       lightPdf(light, receiver, direction, distance, point.normal), shadowDirection, shadowDistance);
}

// ---- From the light into the scene

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

// Flux [W] of the light if all that it emits were like its rays in `direction`: on average over emitFrom, its power.
vec3 rayPower(LightRecord light, vec3 direction) {
    if (!isLight(light.type, kLightEnvironment)) {
        return light.power;
    }
    vec3 radiance = environmentRadiance(light, -direction);
    float pdfW = environmentPdf(light, radiance);
    return pdfW > 0.0 ? radiance * (light.area / pdfW) : vec3(0.0);
}

// Density [1/sr] with which emitFrom would send `direction` from a point with this normal; 0 where it never would, and
// for parallel light.
float emissionDensity(LightRecord light, vec3 normal, vec3 direction) {
    if (isSurface(light.type)) {
        return max(0.0, dot(normal, direction)) * kInvPi;
    }
    if (isLight(light.type, kLightPoint)) {
        return 0.25 * kInvPi;
    }
    if (isLight(light.type, kLightSpot)) {
        return spotPdf(light, direction);
    }
    return isLight(light.type, kLightEnvironment) ? environmentPdf(light, environmentRadiance(light, -direction)) : 0.0;
}

// Where a ray of the light's starts [m].
vec3 startOf(LightRay ray) {
    return ray.origin + ray.error * ray.normal;
}

// Density [1/m^2], across `direction`, with which emitFrom starts its rays of this direction on the line through
// `point`; 0 for lights that choose the origin first. Of parallel light the direction must be its own.
float originDensity(LightRecord light, vec3 point, vec3 direction) {
    bool hasDisc = isLight(light.type, kLightBeam) || isEndless(light.type);
    return hasDisc && passesDisc(light, point, direction) ? 1.0 / light.area : 0.0;
}

// From a disc across the direction that covers all the light is to reach.
LightRay emitFromDisc(LightRecord light, vec3 direction, vec2 u) {
    vec3 onDisc = fromLocal(vec3(light.radius * concentricDisc(u), 0.0), direction);
    return LightRay(light.position - light.distance * direction + onDisc, direction, vec3(0.0), 0.0,
                    rayPower(light, direction), 0.0, 1.0 / light.area);
}

// A ray of the light's photons, whose density is in proportion to the flux.
LightRay emitFrom(LightRecord light, vec2 uOrigin, vec2 uDirection) {
    if (isLight(light.type, kLightEnvironment)) {
        return emitFromDisc(light, -sampleEnvironment(light, uDirection), uOrigin);
    }
    if (isLight(light.type, kLightDirectional) || isLight(light.type, kLightBeam)) {
        return emitFromDisc(light, light.normal, uOrigin);
    }
    LightPoint point = pointOnLight(light, uOrigin);
    vec3 direction = isLight(light.type, kLightPoint)  ? uniformSphere(uDirection)
                     : isLight(light.type, kLightSpot) ? sampleSpot(light, uDirection)
                                                : cosineHemisphere(uDirection, point.normal);
    return LightRay(point.position, direction, point.normal, point.error, light.power,
                    emissionDensity(light, point.normal, direction), 0.0);
}
#endif
