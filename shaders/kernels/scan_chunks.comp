#version 460
#extension GL_GOOGLE_include_directive : require
// Second half of a prefix sum: exclusive sums within every chunk, on top of what precedes the chunk; the total last.
// reads: values, what precedes each chunk
// writes: exclusive sums
// threads: chunks
// computes: second half
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { ScanChunksArguments args; };

void main() {
    uint chunk = threadIndex();
    uint begin = chunk * kScanChunk;
    if (begin >= args.count) {
        return;
    }
    uint end = min(begin + kScanChunk, args.count);
    uint sum = args.chunkOffsets.at[chunk];
    for (uint i = begin; i < end; ++i) {
        uint value = args.values.at[i];
        args.sums.at[i] = sum;
        sum += value;
    }
    if (end == args.count) {
        args.sums.at[end] = sum;
    }
}
