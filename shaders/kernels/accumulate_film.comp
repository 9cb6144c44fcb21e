#version 460
#extension GL_GOOGLE_include_directive : require
// Adds a pass to one layer of the film.
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { AccumulateFilmArguments args; };

void main() {
    uint i = threadIndex();
    if (i < args.count) {
        args.film.at[i] += args.colors.at[i];
    }
}
