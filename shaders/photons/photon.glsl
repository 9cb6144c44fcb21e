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

// An irradiance record has the radius of its disc [m] where a photon has its direction: a float without its last two
// bits.
uint packRecordRadius(float radius) {
    return floatBitsToUint(radius) >> 2u;
}

float recordRadius(uint direction) {
    return uintBitsToFloat(direction << 2u);
}

// Photons whose surface normal deviates by more than 60 degrees lie on another surface; squared cosine.
const float kNormalCosine2 = 0.25;

// Slopes, squared, up to which a chord lies in a plane: between places whose packed normals are the same, and the
// rounding of a packed normal, four times.
const float kFlatness2 = 1.0e-6;
const float kNormalRounding2 = 1.6e-5;

// Rounding of positions, over their largest coordinate: 2^-19.
const float kPlaceError = 1.9073486328125e-6;

// Error of the position of a place and of photons near it [m]; `surfaceError`: that of the scene.
float errorAround(vec3 position, float surfaceError) {
    vec3 size = abs(position);
    return surfaceError + kPlaceError * greater(size.x, greater(size.y, size.z));
}

// A place where photons are looked up, and the tangent plane there.
struct Tangent {
    vec3 normal; // unit, geometric
    uint packed; // the same as photons have it
    float error; // of positions [m], see errorAround
};

Tangent tangentAt(vec3 position, uint geometricNormal, float surfaceError) {
    vec3 normal = normalize(unpackDirection(geometricNormal, 16u));
    return Tangent(normal, packUnitVector(normal, kNormalBits), errorAround(position, surfaceError));
}

// Does the photon, `way` from the place, lie on the same surface? The chord between two places on a plane or an arc of a
// circle makes opposite angles with their tangent planes: way . (n + m) = 0. Where facets meet at edges, half of that is at
// most |way| times the sine of the angle between the normals. So parallel sheets are told apart, however thin: the whole
// distance from sheet to sheet is in way . (n + m) / 2.
bool onSameSurface(Tangent tangent, vec3 way, uint surface) {
    float error2 = tangent.error * tangent.error;
    if ((surface & ((1u << kKindShift) - 1u)) == tangent.packed) {
        float off = dot(way, tangent.normal);
        return off * off <= dot(way, way) * kFlatness2 + error2;
    }
    vec3 photonNormal = unpackDirection(surface, kNormalBits);
    float length2 = dot(photonNormal, photonNormal);
    float cosine = dot(photonNormal, tangent.normal);
    float cosine2 = cosine * cosine / length2;
    if (cosine <= 0.0 || cosine2 <= kNormalCosine2) {
        return false;
    }
    float off = 0.5 * (dot(way, tangent.normal) + dot(way, photonNormal) / sqrt(length2));
    return off * off <= dot(way, way) * (kNormalRounding2 + max(0.0, 1.0 - cosine2)) + error2;
}

// Did it arrive on the side that `normal` points to?
bool onSameSide(vec3 normal, uint direction) {
    return dot(unpackDirection(direction, kDirectionBits), normal) > 0.0;
}

// Photons farther than this from the tangent plane, in radii of the disc, lie on another surface.
const float kPlaneDistance = 0.25;

// Extent along each axis, relative to the radius, of a disc with all photons that count for it.
vec3 discExtent(vec3 normal) {
    return min(vec3(1.0), sqrt(max(vec3(0.0), 1.0 - normal * normal)) + kPlaneDistance * abs(normal));
}
#endif
