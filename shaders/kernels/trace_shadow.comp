#version 460
#extension GL_GOOGLE_include_directive : require
// Adds what a light contributes wherever nothing stands between it and the surface.
// reads: shadow rays, contributions, tables
// writes: direct light
// threads: shadow rays
// computes: adds what nothing blocks
#include "shared/kernel_arguments.h"
#include "shapes/scene.glsl"
#include "lib/counter.glsl"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { TraceShadowArguments args; };

void main() {
    uint count = liveCount(args.live, args.count);
    uint i = liveElement(args.width, count, args.count);
    if (i >= count) {
        return;
    }
    Ray ray = args.shadowRays.at[i];
    bool traces = ray.tMax > 0.0;
    countAll(args.rayCount, traces ? 1u : 0u);
    if (traces && traceScene(args.rootNode, ray, true).object == kNone) {
        uint pixel = isSome(uvec2(args.paths)) ? args.paths.at[i].pixel : i;
        args.direct.at[pixel] += args.contributions.at[i];
    }
}
