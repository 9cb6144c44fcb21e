#version 460
#extension GL_GOOGLE_include_directive : require
// Adds what the paths of one pixel carry, in their order: the first of each run of equal pixels adds them all.
// reads: pixels of paths, their light
// writes: pixels
// threads: paths
// computes: a pixel's tree of rays, summed in order
#include "shared/kernel_arguments.h"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { SumPathsArguments args; };

void main() {
    uint i = threadIndex();
    uint count = liveCount(args.live, args.count);
    if (i >= count) {
        return;
    }
    uint pixel = args.pixels.at[i];
    if (i > 0u && args.pixels.at[i - 1u] == pixel) {
        return;
    }
    vec3 sum = args.radiance.at[pixel];
    for (; i < count && args.pixels.at[i] == pixel; ++i) {
        sum += args.light.at[i];
    }
    args.radiance.at[pixel] = sum;
}
