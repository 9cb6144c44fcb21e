#version 460
#extension GL_GOOGLE_include_directive : require
// Draws the geometry that each ray hits first: normals or distances instead of light.
// reads: rays, hits, tables
// writes: colours
// threads: rays
// computes: normals or distances as colours
#include "shared/kernel_arguments.h"
#include "shapes/surface.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { ShowSurfaceArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    Hit hit = args.hits.at[i];
    vec3 color = vec3(0.0);
    if (hit.object != kNone && args.shown == kShowDepth) {
        color = vec3(hit.t);
    } else if (hit.object != kNone) {
        color = 0.5 + 0.5 * surfaceAt(args.rays.at[i], hit, args.normals, args.instances).normal;
    }
    args.colors.at[i] = color;
}
