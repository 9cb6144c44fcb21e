// A filter of photons that a scene brings along as GLSL (docs/experiments.md). For a scene that has one, the host puts in
// place of this file its source, and a customFilter() that calls it.
#ifndef HYALITE_CUSTOM_FILTER_GLSL
#define HYALITE_CUSTOM_FILTER_GLSL
#include "lib/math.glsl"

// Weight of a photon in a disc; u: its squared distance from the centre over that of the rim, in [0, 1].
float customFilter(float u) {
    return 1.0;
}
#endif
