#version 460
#extension GL_GOOGLE_include_directive : require
// Second half of a prefix sum: exclusive sums within every chunk, on top of what precedes the chunk; the total last.
// reads: values, what precedes each chunk
// writes: exclusive sums
// threads: chunks
// computes: second half
#include "shared/kernel_arguments.h"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { ScanChunksArguments args; };

void main() {
    uint chunk = threadIndex();
    uint begin = chunk * kScanChunk;
    uint count = liveCount(args.live, args.count);
    if (begin >= count) {
        return;
    }
    uint end = min(begin + kScanChunk, count);
    uint sum = args.chunkOffsets.at[chunk];
    for (uint i = begin; i < end; ++i) {
        uint value = args.values.at[i];
        args.sums.at[i] = sum;
        sum += value;
    }
    if (end == count) {
        args.sums.at[end] = sum;
    }
}
