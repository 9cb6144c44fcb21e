// The part of a node's list that one thread processes while a level of the kd-tree is partitioned.
#ifndef HYALITE_KDTREE_CHUNK_GLSL
#define HYALITE_KDTREE_CHUNK_GLSL
#include "photons/kdtree.glsl"

struct NodeChunk {
    uint list;      // the axis along which this list is sorted
    uint number;    // index of the chunk in the node's list
    uint first;     // where the node's list begins
    uint nodeCount; // how long it is
    uint begin;     // where the chunk begins …
    uint end;       // … and ends, in the lists
    uint axis;      // along which the node splits
    KeyedPhoton middle;
};

// Threads are numbered by list, then node, then chunk.
NodeChunk nodeChunk(uint thread, uint level, uint chunks, uint stored, UintArray nodes, KeyedPhotonArray splits) {
    NodeChunk chunk;
    chunk.number = thread % chunks;
    uint node = (thread / chunks) & ((1u << level) - 1u);
    chunk.list = (thread / chunks) >> level;
    KdRange range = kdSubtree(KdRange(0u, stored), level, node);
    chunk.first = chunk.list * stored + range.first;
    chunk.nodeCount = range.count;
    chunk.begin = chunk.first + min(chunk.number * kSplitChunk, range.count);
    chunk.end = chunk.first + min((chunk.number + 1u) * kSplitChunk, range.count);
    chunk.axis = nodes.at[(1u << level) - 1u + node] >> kSplitAxisShift;
    chunk.middle = splits.at[node];
    return chunk;
}
#endif
