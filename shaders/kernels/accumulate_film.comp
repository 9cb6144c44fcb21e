#version 460
#extension GL_GOOGLE_include_directive : require
// Adds one pass to one layer of the film. Floats become fixed-point sums here; values that are not a radiance (NaN,
// infinite, negative, too bright) are counted and left out.
// reads: emission, direct or gathered light
// writes: a layer of the film, counts of invalid values
// threads: pixels
// computes: exact sum over passes
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { AccumulateFilmArguments args; };

FilmSum addValue(FilmSum sum, float value, uint pixel) {
    uint bits = floatBitsToUint(value);
    uint fault = filmFault(bits);
    if (fault == kFilmFaults) {
        FilmSum more = filmAdd(sum, filmSum(bits));
        if (filmIsLess(more, sum) == 0u) {
            return more;
        }
        fault = kFilmTooBright;
    }
    atomicAdd(args.faults.at[2u * fault], 1u);
    atomicMin(args.faults.at[2u * fault + 1u], pixel);
    return sum;
}

void main() {
    uint i = threadIndex();
    if (i < args.count) {
        vec3 color = args.colors.at[i];
        if (color == vec3(0.0)) {
            return; // most pixels of the caustic and emission layers
        }
        FilmColor sum = args.film.at[i];
        sum.red = addValue(sum.red, color.x, i);
        sum.green = addValue(sum.green, color.y, i);
        sum.blue = addValue(sum.blue, color.z, i);
        args.film.at[i] = sum;
    }
}
