// Direct light at a point: the contribution, and the shadow ray that decides whether it arrives.
#ifndef HYALITE_DIRECT_LIGHT_GLSL
#define HYALITE_DIRECT_LIGHT_GLSL
#include "shared/path_records.h"
#include "bsdf/bsdf.glsl"
#include "bsdf/medium.glsl"
#include "lights/receiver.glsl"
#include "lights/light.glsl"
#include "lib/sampling.glsl"

struct DirectLight {
    Ray shadow;
    vec3 contribution; // radiance [W/(m^2 sr)] if unoccluded; not positive: the light is behind the surface or
                       // touches it
    bool discrete;     // no other ray can find this light
};

bool isWorthAsking(DirectLight light) {
    return maxComponent(light.contribution) > 0.0;
}

// The sampler for the light `index`; with kNone, for picking a light.
Sampler lightSampler(uint samplerSeed, uint index, uint pass) {
    return pathSampler(index == kNone ? samplerSeed : deriveSequence(samplerSeed, index), pass);
}

// The requested light; with kNone, one picked for a receiver at x.
LightPick lightAsked(LightArray lights, uint index, vec3 x, Sampler s, uint depth) {
    return index == kNone ? pickLightAt(lights, x, sampleUnit(s, cameraLightChoice(depth - 1u))) : LightPick(index, 1.0);
}

// `pmf`: probability of picking the light. `bounces`: a cosine-distributed ray may hit the same point of it.
DirectLight directLight(LightRecord light, float pmf, VisiblePoint x, Receiver receiver, bool bounces, Sampler s) {
    LightSample toLight = sampleLight(light, x.position, sampleUnit(s, cameraLightPoint(x.depth - 1u)));
    float cosine = dot(x.normal, toLight.direction);
    vec3 f = receiver.f * incidentFactor(receiver, cosine);
    vec3 contribution = f * toLight.irradiance * cosine / pmf;
    if (bounces && toLight.pdfW > 0.0) {
        contribution *= powerHeuristic(pmf * toLight.pdfW, max(cosine, 0.0) * kInvPi);
    }
    return DirectLight(Ray(x.position, toLight.shadowDistance, toLight.shadowDirection, x.from), contribution, toLight.pdfW == 0.0);
}

// At a rough point: rays sampled from the lobe find the same lights, so multiple importance sampling weights the two by
// their densities [Veach95].
DirectLight directLight(LightRecord light, float pmf, RoughPoint x, Lobe lobe, Sampler s) {
    LightSample toLight = sampleLight(light, x.position, sampleUnit(s, cameraLightPoint(x.depth - 1u)));
    BsdfValue value = evaluateLobe(lobe, x.normal, x.geometricNormal, x.wo, toLight.direction, kRadiance);
    float weight = toLight.pdfW > 0.0 ? powerHeuristic(pmf * toLight.pdfW, value.pdfW) : 1.0;
    vec3 contribution = x.beta * value.fCos * toLight.irradiance * (weight / pmf);
    bool through = dot(toLight.direction, x.geometricNormal) < 0.0;
    vec3 off = (through ? -x.error : x.error) * x.geometricNormal;
    Ray shadow = Ray(x.position + off, toLight.shadowDistance, toLight.shadowDirection,
                     through ? x.from ^ kRayInside : x.from);
    if (shadow.tMax < kInfinity) { // to the same point, from the ray's origin
        vec3 way = shadow.tMax * shadow.direction - off;
        shadow.tMax = length(way);
        shadow.direction = way / shadow.tMax;
    }
    return DirectLight(shadow, contribution, toLight.pdfW == 0.0);
}

// The light with absorption by the media around the shadow ray, or, with `passes`, with a shadow ray that passes through
// thin glass and through dielectrics that do not refract it: shadow.glsl then finds what they absorb.
DirectLight throughMedia(DirectLight light, MaterialArray materials, uint media, bool passes) {
    if (mediaNeed(kMediaShadows) && passes) {
        light.shadow.from |= kRayPasses;
    } else {
        light.contribution *= transmittance(materials, media, light.shadow.tMax);
    }
    return light;
}
#endif
