#version 460
#extension GL_GOOGLE_include_directive : require
// Adds what a light contributes wherever nothing stands between it and the surface.
// reads: shadow rays, contributions, tables
// writes: direct light
// threads: shadow rays
// computes: adds what nothing blocks
#include "shared/kernel_arguments.h"
#include "shapes/scene.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { TraceShadowArguments args; };

void main() {
    uint i = threadPixel(args.width, args.count);
    if (i >= args.count) {
        return;
    }
    Ray ray = args.shadowRays.at[i];
    if (ray.tMax > 0.0 && traceScene(args.rootNode, ray, true).object == kNone) {
        args.direct.at[i] += args.contributions.at[i];
    }
}
