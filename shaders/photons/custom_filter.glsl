// A photon filter that a scene supplies as GLSL (docs/experiments.md). For such a scene the host replaces this file
// with its source and a customFilter() that calls it.
#ifndef HYALITE_CUSTOM_FILTER_GLSL
#define HYALITE_CUSTOM_FILTER_GLSL
#include "lib/math.glsl"

// Weight of a photon in a disc; u: its squared distance from the centre over that of the rim, in [0, 1].
float customFilter(float u) {
    return 1.0;
}
#endif
