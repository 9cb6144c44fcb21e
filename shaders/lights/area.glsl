// Area light: each point of the front emits the same radiance in every direction. A quad, disk, sphere or mesh.
#ifndef HYALITE_AREA_GLSL
#define HYALITE_AREA_GLSL
#include "shared/scene_records.h"
#include "lib/sampling.glsl"
#include "lights/choose.glsl"
#include "lights/light_sample.glsl"
#include "lights/start_disc.glsl"
#include "shapes/surface.glsl"

struct LightPoint {
    vec3 position;
    vec3 normal; // unit
    float error; // bound on the rounding of its coordinates [m]: rays start this far off the emitting side
};

LightPoint pointOnSphere(LightRecord light, vec3 normal) {
    float error = kPositionError * (largestCoordinate(light.position) + light.radius);
    return LightPoint(light.position + light.radius * normal, normal, error);
}

LightPoint pointOnMesh(LightRecord light, vec2 u) {
    Choice choice = choose(light.cdfs, 0u, light.columns, u.x);
    LightTriangle triangle = light.triangles.at[choice.index];
    // Maps the square to the triangle by shrinking one side to a corner: uniform if the other coordinate is a square
    // root
    float across = sqrt(choice.rest);
    vec3 p = triangle.corner + across * ((1.0 - u.y) * triangle.edge0 + u.y * triangle.edge1);
    return LightPoint(p, triangle.normal, light.error);
}

// A uniform point on the light.
LightPoint pointOnArea(LightRecord light, vec2 u) {
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

// As pointOnArea, but of a sphere only the half that faces the receiver: the other half cannot light it.
LightPoint pointFacing(LightRecord light, vec3 receiver, vec2 u) {
    if (!isLight(light.type, kLightSphere)) {
        return pointOnArea(light, u);
    }
    vec3 normal = uniformSphere(u);
    return pointOnSphere(light, dot(normal, receiver - light.position) < 0.0 ? -normal : normal);
}

// Area [m^2] that pointFacing samples.
float areaFacing(LightRecord light) {
    return isLight(light.type, kLightSphere) ? 0.5 * light.area : light.area;
}

// Does an unoccluded ray see the front of a quad, disk or sphere?
bool looksAtArea(LightRecord light, vec3 origin, vec3 direction) {
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

// Density [1/sr] of sampleArea for the unit `direction` from a receiver that sees the light there, at this distance and
// with this normal.
float areaPdf(LightRecord light, vec3 direction, float distance, vec3 lightNormal) {
    float cosLight = -dot(direction, lightNormal);
    return cosLight > 0.0 ? distance * distance / (cosLight * areaFacing(light)) : 0.0;
}

LightSample sampleArea(LightRecord light, vec3 receiver, vec2 u) {
    LightPoint point = pointFacing(light, receiver, u);
    vec3 toLight = point.position - receiver;
    float distance2 = dot(toLight, toLight);
    float distance = sqrt(distance2);
    vec3 direction = toLight / distance;
    // The ray's hit on the light also has a rounding error that grows with the distance, however small the light's own
    // coordinates: the ray ends that much earlier
    vec3 toEnd = toLight + (point.error + kPlaneError * distance) * point.normal;
    float shadowDistance = length(toEnd);
    vec3 shadowDirection = toEnd / shadowDistance;
    float cosLight = max(0.0, -dot(direction, point.normal));
    return LightSample(direction, light.emission * (cosLight * areaFacing(light) / distance2),
                       areaPdf(light, direction, distance, point.normal), shadowDirection, shadowDistance);
}

// Density [1/sr] of emitFromArea for `direction`, from a point with this normal.
float areaDensity(vec3 normal, vec3 direction) {
    return max(0.0, dot(normal, direction)) * kInvPi;
}

LightRay emitFromArea(LightRecord light, vec2 uOrigin, vec2 uDirection) {
    LightPoint point = pointOnArea(light, uOrigin);
    vec3 direction = cosineHemisphere(uDirection, point.normal);
    return LightRay(point.position, direction, point.normal, point.error, light.power,
                    areaDensity(point.normal, direction), 0.0);
}
#endif
