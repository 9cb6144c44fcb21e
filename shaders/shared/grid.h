// The photon grid's integer half: which bucket of the hash table a cell belongs to. Cells that follow one another in
// x stand in successive buckets, so that a query reads a row of them as one range.
#ifndef HYALITE_SHARED_GRID_H
#define HYALITE_SHARED_GRID_H
#include "random.h"
SHARED_BEGIN

struct GridRecord {
    float inverseCellSize; // [1/m]; a cell's edge is the search diameter
    uint bucketMask;       // number of buckets, a power of two, less one
};

SHARED_FUNCTION uint cellBucket(ivec3 cell, uint bucketMask) {
    return (hashCombine(uint(cell.y), uint(cell.z)) + uint(cell.x)) & bucketMask;
}

SHARED_END
#endif
