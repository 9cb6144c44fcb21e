#version 460
#extension GL_GOOGLE_include_directive : require
// Spares the shadow rays whose answer the photons gave: what is lit gets its light, what is shadowed gets none.
// reads: lights seen and hidden, shadow rays, contributions
// writes: shadow rays, direct light, counts
// threads: shadow rays
// computes: –
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
