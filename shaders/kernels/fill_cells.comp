#version 460
#extension GL_GOOGLE_include_directive : require
// Lists the photons bucket by bucket; within a bucket the order is still that of arrival.
// reads: photons, cell starts, ranks
// writes: photon numbers by bucket
// threads: photon slots
// computes: counting sort: scatter
#include "shared/kernel_arguments.h"
#include "photons/grid.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { FillCellsArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count || args.photons.at[i].surface == kNone) {
        return;
    }
    uint bucket = bucketOf(args.photons.at[i].position, args.grid);
    args.order.at[args.cellStarts.at[bucket] + args.ranks.at[i]] = i;
}
