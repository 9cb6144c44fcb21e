#version 460
#extension GL_GOOGLE_include_directive : require
// Finds the closest hit of every ray.
// reads: rays, tables of geometry and objects
// writes: hits
// threads: rays
// computes: nearest t of every shape along the ray ([geometry](../../docs/geometry.md))
#include "shared/kernel_arguments.h"
#include "shapes/scene.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { TraceClosestArguments args; };

void main() {
    uint i = threadPixel(args.width, args.count);
    if (i >= args.count) {
        return;
    }
    args.hits.at[i] = traceScene(args.rootNode, args.rays.at[i], false);
}
