#version 460
#extension GL_GOOGLE_include_directive : require
// Samples a light, and a direction to it, for each visible point; writes the shadow ray and the contribution it decides
// about.
// reads: visible points, lights
// writes: shadow rays, contributions, marks of the pixels where light was sought
// threads: visible points
// computes: L = f E cosθ / pmf, pmf by place [ContyEstevez18]: area lights E = Le cosθ' A / d², points I / d², environment Le / pdfW; if
//     paths continue, times p² / (p² + q²), q = cosθ / π [Veach95]
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
    LightPick pick = lightAsked(args.lights, args.light, x.position, s, x.depth);
    Receiver receiver = receiverAt(x, args.materials);
    DirectLight toLight =
        directLight(args.lights.at[pick.light], pick.pmf, x, receiver, args.bounceDepth != 0u, s);
    if (isSome(uvec2(args.sought)) && maxComponent(receiver.f) > 0.0) {
        args.sought.at[x.pixel] = 1u;
    }
    // Of a path that goes on, other rays find the lights behind glass that have a surface
    toLight = throughMedia(toLight, args.materials, x.media, args.bounceDepth != 0u && toLight.discrete);
    if (isWorthAsking(toLight)) {
        args.shadowRays.at[i] = toLight.shadow;
        args.contributions.at[i] = toLight.contribution;
    }
}
