// How many elements a queue holds, as the device knows it: kernels read it, and the next stage is dispatched by it.
#ifndef HYALITE_SHARED_QUEUE_H
#define HYALITE_SHARED_QUEUE_H
#include "limits.h"
#include "path_records.h"
SHARED_BEGIN

SHARED_CONSTANT kScanChunk = 128u; // values that one thread of a prefix sum adds up

// A number of elements, and the dispatch that has a thread for each, as vkCmdDispatchIndirect reads it.
struct QueueSize {
    uint count;
    uint groupsX;
    uint groupsY;
    uint groupsZ;
    uint before; // elements that the queue held in the bounces before, all together
};
DEVICE_ARRAY(QueueSize, QueueSizeArray);

// A queue has a size for every level of a prefix sum over it: its elements, chunks of kScanChunk of them, chunks of
// these, and so on; four levels leave at most 2048 of 2^32.
SHARED_CONSTANT kQueueLevels = 4u;

SHARED_FUNCTION uint chunksOf(uint count) {
    return count == 0u ? 0u : (count - 1u) / kScanChunk + 1u;
}

SHARED_FUNCTION QueueSize queueSize(uint count, uint before) {
    uint groups = count == 0u ? 0u : (count - 1u) / kGroupSize + 1u;
    uint rows = groups == 0u ? 0u : (groups - 1u) / kGroupsPerRow + 1u;
    QueueSize size;
    size.count = count;
    size.groupsX = rows > 1u ? kGroupsPerRow : groups;
    size.groupsY = rows;
    size.groupsZ = 1u;
    size.before = before;
    return size;
}

SHARED_END
#endif
