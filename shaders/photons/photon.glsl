// Photons as the maps store them: how their bits are packed, and whether one counts at a visible point.
#ifndef HYALITE_PHOTON_GLSL
#define HYALITE_PHOTON_GLSL
#include "shared/path_records.h"
#include "lib/math.glsl"
#include "lib/tables.glsl"

// `length`: segments of the photon's path or, for direct and shadow photons, the light.
uint packSurface(vec3 normal, uint kind, uint length) {
    return packUnitVector(normal, kNormalBits) | (kind << kKindShift) | (min(length, kLengthMax) << kLengthShift);
}

uint photonKind(uint surface) {
    return (surface >> kKindShift) & 3u;
}

// Segments of the photon's path.
uint photonLength(uint surface) {
    uint kind = photonKind(surface);
    return kind == kPhotonDirect || kind == kPhotonShadow ? 1u : surface >> kLengthShift;
}

// Photons whose surface normal deviates by more than 60 degrees lie on another surface; squared cosine.
const float kNormalCosine2 = 0.25;

// Did the photon land on a surface whose normal is close to `normal`?
bool onSameSurface(vec3 normal, uint surface) {
    vec3 photonNormal = unpackDirection(surface, kNormalBits);
    float cosine = dot(photonNormal, normal);
    return cosine > 0.0 && cosine * cosine > kNormalCosine2 * dot(photonNormal, photonNormal);
}

// … and arrive on the side that `normal` points to?
bool onSameSide(vec3 normal, uint direction, uint surface) {
    return onSameSurface(normal, surface) && dot(unpackDirection(direction, kDirectionBits), normal) > 0.0;
}

// Photons farther than this from the tangent plane, in radii of the disc, lie on another surface.
const float kPlaneDistance = 0.25;

// Extent along each axis, relative to the radius, of a disc with all photons that count for it.
vec3 discExtent(vec3 normal) {
    return min(vec3(1.0), sqrt(max(vec3(0.0), 1.0 - normal * normal)) + kPlaneDistance * abs(normal));
}
#endif
