// A spot's intensity around its axis: full in the inner cone, zero outside the outer one, and 3 t^2 - 2 t^3 in between,
// where t is linear in the cosine from 0 at the outer cone to 1 at the inner. The mean of that between the cones is
// 1/2, so the flux is pi (inner + outer) times the full intensity, with inner and outer the `cone`.
#ifndef HYALITE_SPOT_GLSL
#define HYALITE_SPOT_GLSL
#include "shared/scene_records.h"
#include "lib/math.glsl"
#include "lights/light_sample.glsl"

// Share of the full intensity in `direction`.
float spotFalloff(LightRecord light, vec3 direction) {
    vec3 off = direction - light.normal;
    float x = 0.5 * dot(off, off); // 1 - cos, in a form that stays accurate in narrow cones
    if (x <= light.cone.x) {
        return 1.0;
    }
    if (x >= light.cone.y) {
        return 0.0;
    }
    float t = (light.cone.y - x) / (light.cone.y - light.cone.x);
    return t * t * (3.0 - 2.0 * t);
}

// The t below which the falloff emits the share u of the flux between the cones: 2 t^3 - t^4 = u. Newton's method
// converges from above, because the left side is convex and u^(1/4) is above the root; the smallest u takes the most
// steps, nine.
float falloffQuantile(float u) {
    float t = sqrt(sqrt(u));
    for (int i = 0; i < 10 && t > 0.0; ++i) {
        t -= (t * t * t * (2.0 - t) - u) / (t * t * (6.0 - 4.0 * t));
    }
    return clamp(t, 0.0, 1.0);
}

// Samples a direction with density proportional to the falloff.
vec3 spotDirection(LightRecord light, vec2 u) {
    float inner = light.cone.x;
    float between = 0.5 * (light.cone.y - inner);
    float x = u.x * (inner + between);
    if (x > inner) {
        x = max(0.0, light.cone.y - 2.0 * between * falloffQuantile(1.0 - min((x - inner) / between, 1.0)));
    }
    float radius = sqrt(x * (2.0 - x));
    vec2 sc = sinCosTurns(u.y);
    return fromLocal(vec3(radius * sc.y, radius * sc.x, 1.0 - x), light.normal);
}

// Density [1/sr] of spotDirection.
float spotDensity(LightRecord light, vec3 direction) {
    return spotFalloff(light, direction) / (kPi * (light.cone.x + light.cone.y));
}

LightSample sampleSpot(LightRecord light, vec3 receiver) {
    vec3 toLight = light.position - receiver;
    float distance2 = dot(toLight, toLight);
    float distance = sqrt(distance2);
    vec3 direction = toLight / distance;
    float share = spotFalloff(light, -direction);
    return LightSample(direction, light.emission * (share / distance2), 0.0, direction, distance);
}

LightRay emitFromSpot(LightRecord light, vec2 uDirection) {
    vec3 direction = spotDirection(light, uDirection);
    return LightRay(light.position, direction, vec3(0.0), 0.0, light.power, spotDensity(light, direction), 0.0);
}
#endif
