// A ray in the space of a quadric or torus, without losing precision when it starts far away.
#ifndef HYALITE_LOCAL_RAY_GLSL
#define HYALITE_LOCAL_RAY_GLSL
#include "lib/math.glsl"
#include "lib/tables.glsl"

// Points p + (t - start) d; t is the parameter of the ray in the world.
struct LocalRay {
    vec3 p; // the ray's point nearest to the origin of the space, as the world measures it
    vec3 d;
    float start;
};

// (o - c) + s d: the terms may be a million times their sum, so the rounding errors are added back (the error-free sum
// and product of [Dekker71], which need no fused multiply-add).
vec3 alongRay(vec3 o, vec3 c, vec3 d, float s) {
    precise vec3 sum = o - c;
    precise vec3 back = sum - o;
    precise vec3 sumError = (o - (sum - back)) - (c + back);
    precise vec3 product = s * d;
    precise float sBig = s * 4097.0;
    precise vec3 dBig = d * 4097.0;
    precise float sHigh = sBig - (sBig - s);
    precise vec3 dHigh = dBig - (dBig - d);
    precise float sLow = s - sHigh;
    precise vec3 dLow = d - dHigh;
    precise vec3 productError = ((sHigh * dHigh - product) + sHigh * dLow + sLow * dHigh) + sLow * dLow;
    precise vec3 result = (sum + product) + (sumError + productError);
    return result;
}

vec3 toLocal(vec4 row0, vec4 row1, vec4 row2, vec3 v) {
    return vec3(dot(row0.xyz, v), dot(row1.xyz, v), dot(row2.xyz, v));
}

LocalRay localRay(uint object, vec3 o, vec3 d) {
    vec4 row0 = objectTexel(object, 0u);
    vec4 row1 = objectTexel(object, 1u);
    vec4 row2 = objectTexel(object, 2u);
    vec3 center = vec3(row0.w, row1.w, row2.w);
    float start = dot(center - o, d);
    return LocalRay(toLocal(row0, row1, row2, alongRay(o, center, d, start)), toLocal(row0, row1, row2, d), start);
}

// Crossings of a line with the surface of a solid: up to four in ascending order, kInfinity for missing ones. The first
// and the third enter it, the others leave it; the first may be -kInfinity.
struct Crossings {
    vec4 t;
    uvec4 part; // see Hit.primitive
};

Crossings noCrossings() {
    return Crossings(vec4(kInfinity), uvec4(0u));
}
#endif
