#version 460
#extension GL_GOOGLE_include_directive : require
// Second half of a radix sort round: moves every photon of the three lists to the place of its digit, keeping the order
// of equal digits. The last round leaves the lists, with all three keys of each photon.
// reads: keys, offsets of each chunk's digits
// writes: keys sorted by one more digit
// threads: chunks
// computes: radix sort: second half of a round
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
