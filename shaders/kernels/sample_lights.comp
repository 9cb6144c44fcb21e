#version 460
#extension GL_GOOGLE_include_directive : require
// Picks a direction to a light for each visible point, and says which shadow ray decides whether its light arrives.
#include "shared/kernel_arguments.h"
#include "lib/diffuse.glsl"
#include "lib/light.glsl"
#include "lib/sampling.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { SampleLightsArguments args; };

void main() {
    uint i = threadPixel(args.width, args.count);
    if (i >= args.count) {
        return;
    }
    args.shadowRays.at[i].tMax = 0.0;
    VisiblePoint x = args.visiblePoints.at[i];
    if (x.depth == 0u || x.depth + 1u > args.maxDepth || (args.bounceDepth != 0u && args.bounceDepth != x.depth)) {
        return;
    }
    uint vertex = x.depth - 1u;
    // One light in proportion to power and share, or the light asked for, with its own numbers
    bool one = args.light == kNone;
    Sampler s = pathSampler(one ? x.samplerSeed : deriveSequence(x.samplerSeed, args.light), args.pass);
    uint index = one ? pickLight(args.lights, args.lightCount, s, cameraLightChoice(vertex)) : args.light;
    LightRecord light = args.lights.at[index];

    LightSample toLight = sampleLight(light, x.position, sampleUnit(s, cameraLightPoint(vertex)));
    float cosine = dot(x.normal, toLight.direction);
    float pmf = one ? light.pmf : 1.0;
    vec3 f = x.f * diffuseFactor(x.coat, cosine);
    vec3 contribution = f * toLight.irradiance * cosine / pmf;
    if (args.bounceDepth != 0u && toLight.pdfW > 0.0) { // a ray by the cosine may meet the same place
        contribution *= powerHeuristic(pmf * toLight.pdfW, max(cosine, 0.0) * kInvPi);
    }
    if (maxComponent(contribution) > 0.0) { // also false when the light is behind the surface or touches it
        args.shadowRays.at[i] = Ray(x.position, toLight.shadowDistance, toLight.shadowDirection, x.from);
        args.contributions.at[i] = contribution;
    }
}
