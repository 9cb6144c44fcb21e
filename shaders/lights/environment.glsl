// Light from beyond the scene, given as an equirectangular image: radiance is constant over each texel. The centre of
// the image is the view along -z, its upper edge is +y.
#ifndef HYALITE_ENVIRONMENT_GLSL
#define HYALITE_ENVIRONMENT_GLSL
#include "shared/scene_records.h"
#include "lib/math.glsl"
#include "lights/choose.glsl"
#include "lights/light_sample.glsl"
#include "lights/start_disc.glsl"

vec3 environmentRadiance(LightRecord light, vec3 direction) {
    float around = turnsOf(-direction.x, direction.z) + light.rotation;
    float down = 2.0 * turnsOf(length(direction.xz), direction.y);
    uint column = min(uint((around - floor(around)) * float(light.columns)), light.columns - 1u);
    uint row = min(uint(down * float(light.rows)), light.rows - 1u);
    return light.texels.at[row * light.columns + column];
}

struct EnvironmentChoice {
    vec3 direction; // unit, towards the light
    vec3 radiance;  // of the chosen texel: rounding may put the direction just beyond the texel's edge
};

// Samples a texel with probability proportional to the mean of its channels times its solid angle, then a uniform
// direction within it: pdfW is proportional to that mean.
EnvironmentChoice chooseEnvironment(LightRecord light, vec2 u) {
    Choice row = choose(light.cdfs, 0u, light.rows, u.y);
    Choice column = choose(light.cdfs, light.rows + row.index * light.columns, light.columns, u.x);
    float top = sinCosTurns(0.5 * float(row.index) / float(light.rows)).y;
    float bottom = sinCosTurns(0.5 * float(row.index + 1u) / float(light.rows)).y;
    float y = clamp(top + row.rest * (bottom - top), -1.0, 1.0);
    float around = (float(column.index) + column.rest) / float(light.columns) - light.rotation;
    vec2 sc = sinCosTurns(around - floor(around));
    float radius = sqrt((1.0 - y) * (1.0 + y));
    return EnvironmentChoice(vec3(-radius * sc.x, y, radius * sc.y),
                             light.texels.at[row.index * light.columns + column.index]);
}

// Density [1/sr] of chooseEnvironment for a direction with this radiance.
float environmentPdf(LightRecord light, vec3 radiance) {
    return dot(radiance, vec3(1.0)) / (4.0 * kPi * dot(light.emission, vec3(1.0)));
}

LightSample sampleEnvironment(LightRecord light, vec2 u) {
    EnvironmentChoice chosen = chooseEnvironment(light, u);
    float pdfW = environmentPdf(light, chosen.radiance);
    return LightSample(chosen.direction, pdfW > 0.0 ? chosen.radiance / pdfW : vec3(0.0), pdfW, chosen.direction, kInfinity);
}

// Flux [W] of the light if every ray that it emits had this radiance.
vec3 environmentRayPower(LightRecord light, vec3 radiance) {
    float pdfW = environmentPdf(light, radiance);
    return pdfW > 0.0 ? radiance * (light.area / pdfW) : vec3(0.0);
}

LightRay emitFromEnvironment(LightRecord light, vec2 uOrigin, vec2 uDirection) {
    EnvironmentChoice chosen = chooseEnvironment(light, uDirection);
    vec3 direction = -chosen.direction;
    return LightRay(pointOnDisc(light, direction, uOrigin), direction, vec3(0.0), 0.0,
                    environmentRayPower(light, chosen.radiance), 0.0, 1.0 / light.area);
}
#endif
