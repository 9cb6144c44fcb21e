#version 460
#extension GL_GOOGLE_include_directive : require
// Lists the slots that hold next rays, compacted and in order; one thread handles a chunk of paths. The rays stay where
// they are: copying them costs more than looking up their slots.
// reads: used slots per path, their sums over chunks
// writes: compacted list of slots, in order
// threads: chunks
// computes: second half of a prefix sum, applied
#include "shared/kernel_arguments.h"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { ListNextRaysArguments args; };

void main() {
    uint chunk = threadIndex();
    uint begin = chunk * kScanChunk;
    uint count = liveCount(args.live, args.count);
    if (begin >= count) {
        return;
    }
    uint end = min(begin + kScanChunk, count);
    uint to = args.chunkOffsets.at[chunk];
    for (uint i = begin; i < end; ++i) {
        uint alive = args.alive.at[i];
        for (uint child = 0u; child < alive; ++child) {
            if (to < args.room) {
                args.slots.at[to] = args.slotsOfPath * i + child;
            }
            ++to;
        }
    }
}
