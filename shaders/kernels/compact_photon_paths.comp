#version 460
#extension GL_GOOGLE_include_directive : require
// Closes the gaps between the photon paths that go on, keeping their order.
// reads: next rays and paths, alive flags, their sums
// writes: rays, paths
// threads: slots
// computes: the same for photons
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { CompactPhotonPathsArguments args; };

void main() {
    uint i = threadIndex();
    if (i < args.count && args.alive.at[i] != 0u) {
        uint to = args.offsets.at[i];
        args.rays.at[to] = args.nextRays.at[i];
        args.paths.at[to] = args.nextPaths.at[i];
    }
}
