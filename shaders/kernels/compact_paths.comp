#version 460
#extension GL_GOOGLE_include_directive : require
// Closes the gaps between the camera or photon paths that go on, keeping their order.
// reads: next rays and paths, camera or photon, alive flags, their sums
// writes: rays, paths
// threads: slots
// computes: surviving paths, without gaps, in order
#include "shared/kernel_arguments.h"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { CompactPathsArguments args; };

void main() {
    uint i = threadIndex();
    if (i < liveCount(args.live, args.count) && args.alive.at[i] != 0u) {
        uint to = args.offsets.at[i];
        args.rays.at[to] = args.nextRays.at[i];
        for (uint word = 0u; word < kPathWords; ++word) {
            args.paths.at[kPathWords * to + word] = args.nextPaths.at[kPathWords * i + word];
        }
    }
}
