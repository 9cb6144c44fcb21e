#version 460
#extension GL_GOOGLE_include_directive : require
// Second half of a radix sort's round: moves every photon of the three lists to where its digit belongs, those of one
// digit in the order they had. The last round leaves the lists, with all three keys of each photon.
// reads: keys, where each chunk's digits go
// writes: keys by one more digit
// threads: chunks
// computes: second half
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { SortDigitsArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    uint chunks = args.count / 3u;
    uint axis = quotient(i, chunks), chunk = i - axis * chunks;
    uint counters = axis * kRadix * chunks + chunk;
    uint end = min((chunk + 1u) * kSortChunk, args.stored);
    for (uint at = chunk * kSortChunk; at < end; ++at) {
        uvec2 pair = args.pairs.at[axis * args.stored + at];
        uint digit = (pair.x >> args.shift) & (kRadix - 1u);
        uint to = args.places.at[counters + digit * chunks];
        args.places.at[counters + digit * chunks] = to + 1u;
        if (args.last == 0u) {
            args.sorted.at[to] = pair;
        } else {
            args.lists.at[to] = args.keys.at[pair.y];
        }
    }
}
