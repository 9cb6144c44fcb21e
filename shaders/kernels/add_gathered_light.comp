#version 460
#extension GL_GOOGLE_include_directive : require
// Adds the light that a gathering ray found to the ray's pixel.
// reads: light found by gathering rays
// writes: gathered light
// threads: pixels
// computes: mean over the rays
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { AddGatheredLightArguments args; };

void main() {
    uint i = threadIndex();
    if (i < args.count) {
        args.gathered.at[i] += args.scale * args.colors.at[i];
    }
}
