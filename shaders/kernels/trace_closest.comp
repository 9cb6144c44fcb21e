#version 460
#extension GL_GOOGLE_include_directive : require
// Finds the closest hit of every ray.
// reads: rays, tables of geometry and objects
// writes: hits
// threads: rays
// computes: nearest t of every shape along the ray ([geometry](../../docs/geometry.md))
#include "shared/kernel_arguments.h"
#include "shapes/scene.glsl"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { TraceClosestArguments args; };

void main() {
    uint count = liveCount(args.live, args.count);
    uint i = liveElement(args.width, count, args.count);
    if (i >= count) {
        return;
    }
    args.hits.at[i] = traceScene(args.rootNode, args.rays.at[i], false);
}
