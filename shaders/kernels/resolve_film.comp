#version 460
#extension GL_GOOGLE_include_directive : require
// Resolves the film to a picture: the mean over passes.
// reads: film
// writes: image
// threads: pixels
// computes: mean over passes
#include "shared/kernel_arguments.h"
#include "film/film.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { ResolveFilmArguments args; };

void main() {
    uint i = threadIndex();
    if (i < args.count) {
        args.image.at[i] = (filmColor(args.first.at[i]) + filmColor(args.second.at[i])) * args.scale;
    }
}
