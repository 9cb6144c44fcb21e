#version 460
#extension GL_GOOGLE_include_directive : require
// Picks a point on a light for each rough point and adds its light if nothing stands between. Rays that leave the lobe
// find the same lights: the two are weighed against one another by the densities with which they find them [Veach95].
#include "shared/kernel_arguments.h"
#include "lib/bsdf.glsl"
#include "lib/light.glsl"
#include "lib/sampling.glsl"
#include "lib/scene.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { SampleRoughLightsArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    RoughPoint x = args.roughPoints.at[i];
    if (x.depth == 0u) {
        return;
    }
    uint vertex = x.depth - 1u;
    bool one = args.light == kNone; // one light in proportion to power; else the light asked for, with its own numbers
    Sampler s = pathSampler(one ? x.samplerSeed : deriveSequence(x.samplerSeed, args.light), args.pass);
    uint index = one ? pickLight(args.lights, args.lightCount, s, cameraLightChoice(vertex)) : args.light;
    LightRecord light = args.lights.at[index];
    float pmf = one ? light.pmf : 1.0;

    LightSample toLight = sampleLight(light, x.position, sampleUnit(s, cameraLightPoint(vertex)));
    BsdfValue value = evaluateLobe(x.lobe, x.normal, x.geometricNormal, x.wo, toLight.direction);
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
    // No contribution: the light is turned away or touches the surface
    if (maxComponent(contribution) > 0.0 && traceScene(args.rootNode, shadow, true).object == kNone) {
        args.direct.at[x.result] += contribution;
    }
}
