// Light that comes to a point straight from a lamp: how much, and the shadow ray that tells whether it does.
#ifndef HYALITE_DIRECT_LIGHT_GLSL
#define HYALITE_DIRECT_LIGHT_GLSL
#include "shared/path_records.h"
#include "bsdf/bsdf.glsl"
#include "lights/receiver.glsl"
#include "lights/light.glsl"
#include "lib/sampling.glsl"

struct DirectLight {
    Ray shadow;
    vec3 contribution; // radiance [W/(m^2 sr)] if nothing stands between; not positive: the light is behind the surface or
                       // touches it
};

bool isWorthAsking(DirectLight light) {
    return maxComponent(light.contribution) > 0.0;
}

// The numbers that sample the light `index`, or with kNone one that they pick.
Sampler lightSampler(uint samplerSeed, uint index, uint pass) {
    return pathSampler(index == kNone ? samplerSeed : deriveSequence(samplerSeed, index), pass);
}

// The light asked for, or with kNone one by the lights' pmf.
uint lightAsked(LightArray lights, uint lightCount, uint index, Sampler s, uint depth) {
    return index == kNone ? pickLight(lights, lightCount, s, cameraLightChoice(depth - 1u)) : index;
}

// `pmf`: with which probability the light was picked. `bounces`: a ray by the cosine may meet the same place.
DirectLight directLight(LightRecord light, float pmf, VisiblePoint x, Receiver receiver, bool bounces, Sampler s) {
    LightSample toLight = sampleLight(light, x.position, sampleUnit(s, cameraLightPoint(x.depth - 1u)));
    float cosine = dot(x.normal, toLight.direction);
    vec3 f = receiver.f * incidentFactor(receiver, cosine);
    vec3 contribution = f * toLight.irradiance * cosine / pmf;
    if (bounces && toLight.pdfW > 0.0) {
        contribution *= powerHeuristic(pmf * toLight.pdfW, max(cosine, 0.0) * kInvPi);
    }
    return DirectLight(Ray(x.position, toLight.shadowDistance, toLight.shadowDirection, x.from), contribution);
}

// At a rough point: rays that leave the lobe find the same lights, and the two are weighed against one another by the
// densities with which they find them [Veach95].
DirectLight directLight(LightRecord light, float pmf, RoughPoint x, Lobe lobe, Sampler s) {
    LightSample toLight = sampleLight(light, x.position, sampleUnit(s, cameraLightPoint(x.depth - 1u)));
    BsdfValue value = evaluateLobe(lobe, x.normal, x.geometricNormal, x.wo, toLight.direction, kRadiance);
    float weight = toLight.pdfW > 0.0 ? powerHeuristic(pmf * toLight.pdfW, value.pdfW) : 1.0;
    vec3 contribution = x.beta * value.fCos * toLight.irradiance * (weight / pmf);
    bool through = dot(toLight.direction, x.geometricNormal) < 0.0;
    vec3 off = (through ? -x.error : x.error) * x.geometricNormal;
    Ray shadow = Ray(x.position + off, toLight.shadowDistance, toLight.shadowDirection,
                     through ? x.from ^ kRayInside : x.from);
    if (shadow.tMax < kInfinity) { // to the same place, from where the ray starts
        vec3 way = shadow.tMax * shadow.direction - off;
        shadow.tMax = length(way);
        shadow.direction = way / shadow.tMax;
    }
    return DirectLight(shadow, contribution);
}
#endif
