#version 460
#extension GL_GOOGLE_include_directive : require
// A prefix sum of few values by one workgroup: each thread adds up its share of them, and starts with what the threads
// before it have found. Where three dispatches in turn would cost more than the core that stands idle meanwhile. Whatever
// the number of values, the sums over a queue's flags end here: the total is how large the queue will be.
// reads: values; of a queue's flags, the queue's size
// writes: exclusive sums; of a queue's flags, its next size
// threads: one workgroup
// computes: prefix sum of few values
#include "shared/kernel_arguments.h"
#include "lib/counter.glsl"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { ScanGroupArguments args; };

shared uint shares[kGroupSize];

void writeNextQueue(uint count) {
    QueueSize queue = args.queue.at[0];
    for (uint level = 0u; level < kQueueLevels; ++level) {
        args.next.at[level] = queueSize(count, queue.before + queue.count);
        count = chunksOf(count);
    }
    countAlone(args.elementCount, queue.count);
}

void main() {
    uint thread = threadIndex();
    uint count = liveCount(args.live, args.count);
    uint share = (count + kGroupSize - 1u) / kGroupSize;
    uint begin = min(thread * share, count);
    uint end = min(begin + share, count);
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
        args.sums.at[count] = sum;
        if (isSome(uvec2(args.queue))) {
            writeNextQueue(sum);
        }
    }
}
