#version 460
#extension GL_GOOGLE_include_directive : require
// Adds colours to sums: a pass to one layer of the film, a gathering ray to the light of its pixel.
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { AccumulateFilmArguments args; };

void main() {
    uint i = threadIndex();
    if (i < args.count) {
        args.film.at[i] += args.scale * args.colors.at[i];
    }
}
