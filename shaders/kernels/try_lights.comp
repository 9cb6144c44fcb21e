#version 460
#extension GL_GOOGLE_include_directive : require
// Tries every light at every place, before the first pass: which lights matter where the camera looks?
// reads: visible points, lights, tables
// writes: light brought, numbers of tries
// threads: places times lights
// computes: L = f E cosθ if unoccluded, as sample_lights for a given light
#include "shared/kernel_arguments.h"
#include "shared/try_lights_arguments.h"
#include "lights/direct_light.glsl"
#include "shapes/scene.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { TryLightsArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    VisiblePoint x = args.visiblePoints.at[i % args.places];
    if (x.depth == 0u || x.depth != args.depth) {
        return;
    }
    uint light = i / args.places;
    Sampler s = lightSampler(x.samplerSeed, light, args.pass);
    DirectLight toLight = directLight(args.lights.at[light], 1.0, x, receiverAt(x, args.materials), false, s);
    if (!isWorthAsking(toLight)) {
        return;
    }
    bool seen = traceScene(args.rootNode, toLight.shadow, true).object == kNone;
    args.tries.at[i] += uvec2(1u, seen ? 1u : 0u);
    if (seen) {
        args.brought.at[i] += dot(toLight.contribution, vec3(1.0 / 3.0));
    }
}
