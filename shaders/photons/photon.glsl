// Photons as the maps hold them: how their bits are packed, and whether one tells of the light at a visible point.
#ifndef HYALITE_PHOTON_GLSL
#define HYALITE_PHOTON_GLSL
#include "shared/path_records.h"
#include "lib/math.glsl"
#include "lib/tables.glsl"

// `length`: segments of the photon's path or, of direct and shadow photons, the light.
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

// Photons whose surface is turned away by more than 60 degrees lie on another one; the square of the cosine.
const float kNormalCosine2 = 0.25;

// Did the photon land on a surface that faces where `normal` points?
bool onSameSurface(vec3 normal, uint surface) {
    vec3 photonNormal = unpackDirection(surface, kNormalBits);
    float cosine = dot(photonNormal, normal);
    return cosine > 0.0 && cosine * cosine > kNormalCosine2 * dot(photonNormal, photonNormal);
}

// … and come from the side that `normal` stands on?
bool onSameSide(vec3 normal, uint direction, uint surface) {
    return onSameSurface(normal, surface) && dot(unpackDirection(direction, kDirectionBits), normal) > 0.0;
}

// Photons farther than this from the tangent plane, in radii of the disc, lie on another surface.
const float kPlaneDistance = 0.25;

// How far such a disc with all photons that count for it reaches along each axis, over its radius.
vec3 discExtent(vec3 normal) {
    return min(vec3(1.0), sqrt(max(vec3(0.0), 1.0 - normal * normal)) + kPlaneDistance * abs(normal));
}
#endif
