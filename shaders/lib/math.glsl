// Small maths with the same bits on every machine: built only on + - * / sqrt, which Vulkan drivers for CPUs round
// correctly, never on the driver's own sin, cos or acos.
#ifndef HYALITE_MATH_GLSL
#define HYALITE_MATH_GLSL
#include "shared/language.h"

const float kPi = 3.14159265358979;
const float kInvPi = 0.318309886183791;
const float kInfinity = 3.0e38; // longer than any ray; finite, so that products with zero stay zero
const float kTiny = 1.0e-30;    // greater than zero, less than any length
const float kEndless = 1.0e28;  // distances beyond this mark the open end of an unbounded shape

// max and min, except that they return the second operand if either is NaN. lavapipe takes eight instructions for a
// NaN-safe max or min, and splits its longest vectors for them; each of these is one instruction.
float greater(float a, float b) {
    return a > b ? a : b;
}

vec2 greater(vec2 a, vec2 b) {
    return mix(b, a, greaterThan(a, b));
}

vec3 greater(vec3 a, vec3 b) {
    return mix(b, a, greaterThan(a, b));
}

vec4 greater(vec4 a, vec4 b) {
    return mix(b, a, greaterThan(a, b));
}

float lesser(float a, float b) {
    return a < b ? a : b;
}

vec3 lesser(vec3 a, vec3 b) {
    return mix(b, a, lessThan(a, b));
}

vec4 lesser(vec4 a, vec4 b) {
    return mix(b, a, lessThan(a, b));
}

// Converts an integral x to int, for |x| <= 2^22: it is the low bits of 3 * 2^22 + x. On lavapipe int(x) runs lane by
// lane, and also handles NaN and values out of range.
int integerOf(float x) {
    return floatBitsToInt(x + 12582912.0) - 0x4b400000;
}

ivec2 integerOf(vec2 x) {
    return floatBitsToInt(x + 12582912.0) - 0x4b400000;
}

ivec3 integerOf(vec3 x) {
    return floatBitsToInt(x + 12582912.0) - 0x4b400000;
}

// (sin x, cos x) for |x| <= pi/4: Taylor series, error below 1 ulp of 1.
vec2 sinCosSmall(float x) {
    float s = x * x;
    return vec2(x * (1.0 + s * (-1.0 / 6.0 + s * (1.0 / 120.0 + s * (-1.0 / 5040.0 + s * (1.0 / 362880.0))))),
                1.0 + s * (-0.5 + s * (1.0 / 24.0 + s * (-1.0 / 720.0 + s * (1.0 / 40320.0 + s * (-1.0 / 3628800.0))))));
}

// (sin, cos) of `turns` times 2 pi, 0 <= turns <= 1.
vec2 sinCosTurns(float turns) {
    float quarter = floor(4.0 * turns + 0.5);
    vec2 sc = sinCosSmall((turns - 0.25 * quarter) * (2.0 * kPi));
    uint q = uint(integerOf(quarter)) & 3u;
    if ((q & 1u) != 0u) {
        sc = vec2(sc.y, -sc.x);
    }
    return (q & 2u) != 0u ? -sc : sc;
}

// e^x for x <= 0; 0 for x <= -87. With x = k ln 2 + r and |r| <= ln 2 / 2, 2^k is exact, and the Taylor series of e^r
// to r^7 has an error of 6e-9. ln 2 is subtracted in two parts; the first times k is exact.
float exponential(float x) {
    if (x <= -87.0) {
        return 0.0;
    }
    float k = floor(1.44269504 * x + 0.5);
    float r = (x - k * 0.693359375) + k * 2.12194440e-4;
    float tail = 1.0 / 6.0 + r * (1.0 / 24.0 + r * (1.0 / 120.0 + r * (1.0 / 720.0 + r * (1.0 / 5040.0))));
    return (1.0 + (r + r * r * (0.5 + r * tail))) * uintBitsToFloat(uint(integerOf(k) + 127) << 23u);
}

// The angle from the x axis to (x, y) as a fraction of a full turn, in [-1/2, 1/2]; error below 1e-7. For t >
// tan(pi/8), atan t = pi/4 + atan((t - 1) / (t + 1)), which keeps the Taylor series short.
float angleInTurns(float y, float x) {
    float across = min(abs(x), abs(y));
    float along = max(max(abs(x), abs(y)), 1.0e-30);
    float t = across / along;
    bool isLarge = t > 0.414213562;
    t = isLarge ? (t - 1.0) / (t + 1.0) : t;
    float s = t * t;
    float series = s * (-1.0 / 3.0 + s * (1.0 / 5.0 + s * (-1.0 / 7.0 + s * (1.0 / 9.0 + s * (-1.0 / 11.0
                 + s * (1.0 / 13.0 + s * (-1.0 / 15.0)))))));
    float turns = (isLarge ? 0.125 : 0.0) + 0.5 * kInvPi * (t + t * series);
    turns = abs(y) > abs(x) ? 0.25 - turns : turns;
    turns = x < 0.0 ? 0.5 - turns : turns;
    return y < 0.0 ? -turns : turns;
}

// The same counter-clockwise, in [0, 1]; 0 for the zero vector.
float turnsOf(float y, float x) {
    float turns = angleInTurns(y, x);
    return turns < 0.0 ? 1.0 + turns : turns;
}

// A NaN component may be taken or ignored.
float maxComponent(vec3 v) {
    return greater(v.x, greater(v.y, v.z));
}

// Moves components away from zero: below 1e-18 they count as zero, but their inverse must stay finite when multiplied.
vec3 awayFromZero(vec3 v) {
    return mix(v, vec3(1.0e-18), lessThan(abs(v), vec3(1.0e-18)));
}

// Converts from the orthonormal basis whose third axis is the unit vector n [Duff17].
vec3 fromLocal(vec3 local, vec3 n) {
    float s = n.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    vec3 tangent = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
    vec3 bitangent = vec3(b, s + n.y * n.y * a, -n.y);
    return local.x * tangent + local.y * bitangent + local.z * n;
}

// The inverse: the coordinates of v in that basis.
vec3 intoFrame(vec3 v, vec3 n) {
    float s = n.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    vec3 tangent = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
    vec3 bitangent = vec3(b, s + n.y * n.y * a, -n.y);
    return vec3(dot(v, tangent), dot(v, bitangent), dot(v, n));
}

// Packs a unit vector as a point of the unfolded octahedron [Cigolle14], `bits` per coordinate.
uint packUnitVector(vec3 v, uint bits) {
    vec2 p = v.xy / (abs(v.x) + abs(v.y) + abs(v.z));
    if (v.z < 0.0) {
        p = (1.0 - abs(p.yx)) * vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    }
    float scale = float((1u << bits) - 1u);
    uvec2 q = uvec2(integerOf(floor(clamp(p * 0.5 + 0.5, 0.0, 1.0) * scale + 0.5)));
    return q.x | (q.y << bits);
}

// A vector in the packed direction; its length, between 1/sqrt(3) and 1, has no meaning.
vec3 unpackDirection(uint packed, uint bits) {
    uint mask = (1u << bits) - 1u;
    vec2 p = vec2(packed & mask, (packed >> bits) & mask) * (2.0 / float(mask)) - 1.0;
    vec3 v = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (v.z < 0.0) {
        v.xy = (1.0 - abs(p.yx)) * vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    }
    return v;
}
#endif
