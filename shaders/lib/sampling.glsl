// Random numbers as floats, and the maps from the unit square that sample directions.
#ifndef HYALITE_SAMPLING_GLSL
#define HYALITE_SAMPLING_GLSL
#include "shared/random.h"
#include "lib/math.glsl"

// The top 24 bits as a number in [0, 1), exact in float.
vec2 toUnit(uvec2 bits) {
    return vec2(bits >> 8u) * 5.9604644775390625e-8; // 2^-24
}

vec2 sampleUnit(Sampler s, uint dimension) {
    return toUnit(sampleBits(s, dimension));
}

// Uniform on the unit disc; neighbours in the square stay neighbours on the disc [Shirley97].
vec2 concentricDisc(vec2 u) {
    vec2 p = 2.0 * u - 1.0;
    if (p.x == 0.0 && p.y == 0.0) {
        return vec2(0.0);
    }
    if (abs(p.x) > abs(p.y)) {
        vec2 sc = sinCosSmall(0.25 * kPi * (p.y / p.x));
        return p.x * sc.yx;
    }
    vec2 sc = sinCosSmall(0.25 * kPi * (p.x / p.y));
    return p.y * sc;
}

// Direction around the unit normal n with density cos / pi.
vec3 cosineHemisphere(vec2 u, vec3 n) {
    vec2 disc = concentricDisc(u);
    float z = sqrt(max(0.0, 1.0 - dot(disc, disc)));
    return fromLocal(vec3(disc, z), n);
}

// Direction with density 1 / (4 pi).
vec3 uniformSphere(vec2 u) {
    float z = 1.0 - 2.0 * u.x;
    float radius = sqrt(max(0.0, 1.0 - z * z));
    vec2 sc = sinCosTurns(u.y);
    return vec3(radius * sc.y, radius * sc.x, z);
}

// Weight of a sample of density `pdf` if another technique finds the same sample with density `other`: the power
// heuristic [Veach95].
float powerHeuristic(float pdf, float other) {
    float ratio = other / pdf;
    return 1.0 / (1.0 + ratio * ratio);
}
#endif
