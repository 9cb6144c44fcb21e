#version 460
#extension GL_GOOGLE_include_directive : require
// Skips the shadow rays whose answer the photons gave: adds the light where it is visible, drops it where it is
// occluded.
// reads: visible and occluded lights, shadow rays, contributions
// writes: shadow rays, direct light, counts
// threads: shadow rays
// computes: shadow photons replace shadow rays [JensenChristensen95]
#include "shared/kernel_arguments.h"
#include "lib/counter.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { SkipShadowRaysArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count || args.shadowRays.at[i].tMax == 0.0) {
        return;
    }
    bool lit = ((args.lit.at[i] >> args.light) & 1u) != 0u;
    bool shadowed = ((args.shadowed.at[i] >> args.light) & 1u) != 0u;
    bool known = lit || shadowed;
    countAll(args.raysSaved, known ? 1u : 0u);
    if (!known) {
        return;
    }
    if (lit) {
        args.direct.at[i] += args.contributions.at[i];
    }
    args.shadowRays.at[i].tMax = 0.0;
}
