#version 460
#extension GL_GOOGLE_include_directive : require
// Picks a direction to a light for each visible point, and says which shadow ray decides whether its light arrives.
// reads: visible points, lights
// writes: shadow rays, contributions
// threads: visible points
// computes: L = f E cosθ / pmf: of surfaces E = Le cosθ' A / d², of points I / d², of the environment Le / pdfW; where
//     paths go on, times p² / (p² + q²), q = cosθ / π [Veach95]
#include "shared/kernel_arguments.h"
#include "lights/direct_light.glsl"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { SampleLightsArguments args; };

void main() {
    uint count = liveCount(args.live, args.count);
    uint i = liveElement(args.width, count, args.count);
    if (i >= count) {
        return;
    }
    args.shadowRays.at[i].tMax = 0.0;
    VisiblePoint x = args.visiblePoints.at[isSome(uvec2(args.paths)) ? args.paths.at[i].pixel : i];
    if (x.depth == 0u || x.depth + 1u > args.maxDepth || (args.bounceDepth != 0u && args.bounceDepth != x.depth)) {
        return;
    }
    Sampler s = lightSampler(x.samplerSeed, args.light, args.pass);
    LightRecord light = args.lights.at[lightAsked(args.lights, args.lightCount, args.light, s, x.depth)];
    DirectLight toLight = directLight(light, args.light == kNone ? light.pmf : 1.0, x, receiverAt(x, args.materials),
                                       args.bounceDepth != 0u, s);
    if (isWorthAsking(toLight)) {
        args.shadowRays.at[i] = toLight.shadow;
        args.contributions.at[i] = toLight.contribution;
    }
}
