#version 460
#extension GL_GOOGLE_include_directive : require
// First half of a prefix sum: the sum of every chunk of kScanChunk values.
// reads: values
// writes: sums of chunks
// threads: chunks
// computes: first half of a prefix sum of many
#include "shared/kernel_arguments.h"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { SumChunksArguments args; };

void main() {
    uint chunk = threadIndex();
    uint begin = chunk * kScanChunk;
    uint count = liveCount(args.live, args.count);
    if (begin >= count) {
        return;
    }
    uint end = min(begin + kScanChunk, count);
    uint sum = 0u;
    for (uint i = begin; i < end; ++i) {
        sum += args.values.at[i];
    }
    args.sums.at[chunk] = sum;
}
