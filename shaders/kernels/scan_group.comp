#version 460
#extension GL_GOOGLE_include_directive : require
// A prefix sum of few values by one workgroup: each thread adds up its share of them, and starts with what the threads
// before it have found. Where three dispatches in turn would cost more than the core that stands idle meanwhile.
// reads: values
// writes: exclusive sums
// threads: one workgroup
// computes: prefix sum of few values
#include "shared/kernel_arguments.h"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { ScanGroupArguments args; };

shared uint shares[kGroupSize];

void main() {
    uint thread = threadIndex();
    uint share = (args.count + kGroupSize - 1u) / kGroupSize;
    uint begin = min(thread * share, args.count);
    uint end = min(begin + share, args.count);
    uint sum = 0u;
    for (uint i = begin; i < end; ++i) {
        sum += args.values.at[i];
    }
    shares[thread] = sum;
    barrier();
    sum = 0u;
    for (uint before = 0u; before < thread; ++before) {
        sum += shares[before];
    }
    for (uint i = begin; i < end; ++i) {
        uint value = args.values.at[i];
        args.sums.at[i] = sum;
        sum += value;
    }
    if (thread == kGroupSize - 1u) {
        args.sums.at[args.count] = sum;
    }
}
