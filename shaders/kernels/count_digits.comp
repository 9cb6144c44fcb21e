#version 460
#extension GL_GOOGLE_include_directive : require
// First half of a radix sort round: counts how often each digit occurs in every chunk of the three lists.
// reads: keys along three axes
// writes: digits per chunk
// threads: chunks
// computes: radix sort: first half of a round
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { CountDigitsArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    uint chunks = args.count / 3u;
    uint axis = quotient(i, chunks), chunk = i - axis * chunks;
    // Indexed by axis, then digit, then chunk: the exclusive sums say where each chunk's photons of each digit go
    uint counters = axis * kRadix * chunks + chunk;
    for (uint digit = 0u; digit < kRadix; ++digit) {
        args.counts.at[counters + digit * chunks] = 0u;
    }
    uint end = min((chunk + 1u) * kSortChunk, args.stored);
    for (uint at = chunk * kSortChunk; at < end; ++at) {
        uint digit = (args.pairs.at[axis * args.stored + at].x >> args.shift) & (kRadix - 1u);
        args.counts.at[counters + digit * chunks] += 1u;
    }
}
