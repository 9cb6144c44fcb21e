#version 460
#extension GL_GOOGLE_include_directive : require
// Sorts every bucket by photon number, so that sums over it always have the same order and result: insertion sort for
// the usual handful of photons, heap sort for the thousands of a caustic.
// reads: cell starts, photon numbers
// writes: the same, ascending in each bucket
// threads: buckets
// computes: sort by photon number: makes later sums reproducible
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { OrderCellsArguments args; };

const uint kInsertionLimit = 24u;

void insertionSort(uint first, uint count) {
    for (uint i = 1u; i < count; ++i) {
        uint value = args.order.at[first + i];
        uint j = i;
        while (j > 0u) {
            uint before = args.order.at[first + j - 1u];
            if (before <= value) {
                break;
            }
            args.order.at[first + j] = before;
            --j;
        }
        args.order.at[first + j] = value;
    }
}

// Sifts `value` down from `node` to its place in the heap of `count` values, the largest on top.
void siftDown(uint first, uint node, uint count, uint value) {
    while (2u * node + 1u < count) {
        uint child = 2u * node + 1u;
        uint larger = args.order.at[first + child];
        if (child + 1u < count) {
            uint right = args.order.at[first + child + 1u];
            if (right > larger) {
                larger = right;
                ++child;
            }
        }
        if (larger <= value) {
            break;
        }
        args.order.at[first + node] = larger;
        node = child;
    }
    args.order.at[first + node] = value;
}

void heapSort(uint first, uint count) {
    for (uint node = count / 2u; node > 0u; --node) {
        siftDown(first, node - 1u, count, args.order.at[first + node - 1u]);
    }
    for (uint last = count - 1u; last > 0u; --last) {
        uint value = args.order.at[first + last];
        args.order.at[first + last] = args.order.at[first];
        siftDown(first, 0u, last, value);
    }
}

void main() {
    uint bucket = threadIndex();
    if (bucket >= args.count) {
        return;
    }
    uint first = args.cellStarts.at[bucket];
    uint end = args.cellStarts.at[bucket + 1u];
    if (end <= first) {
        return;
    }
    uint count = end - first;
    if (count > kInsertionLimit) {
        heapSort(first, count);
    } else if (count > 1u) {
        insertionSort(first, count);
    }
}
