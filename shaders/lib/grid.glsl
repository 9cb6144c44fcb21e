// The photon grid: space cut into cubic cells, cells hashed into buckets.
#ifndef HYALITE_GRID_GLSL
#define HYALITE_GRID_GLSL
#include "shared/grid.h"
#include "shared/path_records.h"

ivec3 cellOf(vec3 position, GridRecord grid) {
    // Far outside any sensible scene cells merge; the distance test of a query still decides.
    return ivec3(clamp(floor(position * grid.inverseCellSize), vec3(-1.0e9), vec3(1.0e9)));
}

uint bucketOf(vec3 position, GridRecord grid) {
    return cellBucket(cellOf(position, grid), grid.bucketMask);
}

// The photons that a query has to look at: four rows of two cells, each row one range of the sorted photons, and what
// lies beyond the end of the table in the rare row that wraps around to bucket 0.
struct Ranges {
    uvec4 first;
    uvec4 end;
    uint wrappedEnd;
};

// A cell is as wide as the disc, which so reaches into two cells along each axis. Different cells may share a bucket:
// a bucket that an earlier row holds is left out of a later one, so that no photon is met twice.
Ranges candidateRanges(vec3 position, float radius, GridRecord grid, UintArray cellStarts) {
    ivec3 low = cellOf(position - radius, grid);
    uint mask = grid.bucketMask;
    uvec4 bucket;
    Ranges ranges;
    ranges.wrappedEnd = 0u;
    for (int row = 0; row < 4; ++row) {
        bucket[row] = cellBucket(low + ivec3(0, row & 1, row >> 1), mask);
        bool takeFirst = true, takeSecond = true;
        for (int earlier = 0; earlier < row; ++earlier) {
            uint ahead = (bucket[row] - bucket[earlier]) & mask;
            takeFirst = takeFirst && ahead != 0u && ahead != 1u;
            takeSecond = takeSecond && ahead != 0u && ahead != mask;
        }
        bool wraps = bucket[row] == mask;
        ranges.first[row] = cellStarts.at[bucket[row] + (takeFirst ? 0u : 1u)];
        ranges.end[row] = cellStarts.at[bucket[row] + (takeSecond && !wraps ? 2u : 1u)];
        if (wraps && takeSecond) {
            ranges.wrappedEnd = cellStarts.at[1];
        }
    }
    return ranges;
}
#endif
