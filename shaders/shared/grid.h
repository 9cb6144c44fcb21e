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

// Cells farther than this from the origin along an axis merge with the last: the distance test of a query still
// decides.
SHARED_FLOAT kFarthestCell = 4194304.0; // 2^22

// Two odd numbers far from each other and from 0, and so are their sum and difference, by any power of two from 1024
// on: rows of cells side by side stand far apart. So a ball no wider than a cell, which reaches into two by two rows
// and two cells of each, meets every photon once.
SHARED_FUNCTION uint cellBucket(ivec3 cell, uint bucketMask) {
    return (uint(cell.x) + 0x9e3779b1u * uint(cell.y) + 0x85ebca77u * uint(cell.z)) & bucketMask;
}

SHARED_END
#endif
