#version 460
#extension GL_GOOGLE_include_directive : require
// Counts the photons in every bucket of the grid; empty slots are skipped.
// reads: photons
// writes: photons per bucket, rank of each photon in its bucket
// threads: photon slots
// computes: bucket = hash(y, z) + x
#include "shared/kernel_arguments.h"
#include "photons/grid.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { CountCellsArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count || args.photons.at[i].surface == kNone) {
        return;
    }
    uint bucket = bucketOf(args.photons.at[i].position, args.grid);
    args.ranks.at[i] = atomicAdd(args.cellCounts.at[bucket], 1u);
}
