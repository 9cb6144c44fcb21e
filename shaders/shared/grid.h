// The photon grid's integer half: the hash bucket of a cell. Cells that follow one another in x are successive buckets,
// so that a query reads a row of them as one range.
#ifndef HYALITE_SHARED_GRID_H
#define HYALITE_SHARED_GRID_H
#include "random.h"
SHARED_BEGIN

struct GridRecord {
    float inverseCellSize; // [1/m]; a cell's edge is the search diameter
    uint bucketMask;       // number of buckets, a power of two, less one
};

// Cells farther than this from the origin along an axis merge with the last one: the distance test of a query still
// decides.
SHARED_FLOAT kFarthestCell = 4194304.0; // 2^22

// Two odd factors: they, their sum and their difference are far from each other and from 0 modulo any power of two from
// 1024 up, so adjacent rows of cells are far apart in the table. A ball no wider than a cell overlaps two by two rows
// of two cells, and therefore meets every photon once.
SHARED_FUNCTION uint cellBucket(ivec3 cell, uint bucketMask) {
    return (uint(cell.x) + 0x9e3779b1u * uint(cell.y) + 0x85ebca77u * uint(cell.z)) & bucketMask;
}

SHARED_END
#endif
