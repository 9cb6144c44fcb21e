#version 460
#extension GL_GOOGLE_include_directive : require
// Lists the slots where next rays stand, without gaps and in order, a chunk of paths a thread. The rays themselves stay
// where they are: to copy them costs more than to look up where they stand.
// reads: used slots of paths, their sums over chunks
// writes: slots, without gaps, in order
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
