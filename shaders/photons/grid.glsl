// The photon grid: space cut into cubic cells, cells hashed into buckets.
#ifndef HYALITE_GRID_GLSL
#define HYALITE_GRID_GLSL
#include "shared/grid.h"
#include "shared/path_records.h"
#include "lib/math.glsl"

ivec3 cellOf(vec3 position, GridRecord grid) {
    vec3 cell = floor(position * grid.inverseCellSize);
    return integerOf(lesser(greater(cell, vec3(-kFarthestCell)), vec3(kFarthestCell)));
}

uint bucketOf(vec3 position, GridRecord grid) {
    return cellBucket(cellOf(position, grid), grid.bucketMask);
}

// A walk through the cells that a part of a ball overlaps, row by row along x. The cells of a row are successive
// buckets: each row is one range of the sorted photons, or two if it wraps around the end of the table.
struct CellWalk {
    ivec2 row;      // y and z of the cells of the present row
    ivec2 next;     // of the next row
    ivec2 low;      // of the first row
    ivec2 high;     // of the last row
    uint wrapped;   // number of buckets at the beginning of the table that also belong to the present row
    vec3 position;  // the ball's centre [m]
    float reach2;   // its squared radius, padded so that rounding cannot lose a photon [m^2]
    float along;    // extent of the part along x, padded likewise [m]
};

// The part lies within `extent` of the ball's centre along each axis [m].
CellWalk walkCells(vec3 position, float radius, vec3 extent, GridRecord grid) {
    const float more = 1.0009765625;
    vec3 reach = more * extent;
    ivec2 low = cellOf(position - reach, grid).yz;
    ivec2 high = cellOf(position + reach, grid).yz;
    return CellWalk(low, low, low, high, 0u, position, more * more * radius * radius, reach.x);
}

// The next range of photons, from `first` up to but not including `end`; it may be empty. false: the walk is over.
bool nextRange(inout CellWalk walk, GridRecord grid, UintArray cellStarts, out uint first, out uint end) {
    first = 0u;
    end = 0u;
    if (walk.wrapped > 0u) {
        end = cellStarts.at[walk.wrapped];
        walk.wrapped = 0u;
        return true;
    }
    if (walk.next.y > walk.high.y) {
        return false;
    }
    walk.row = walk.next;
    bool isLastOfLayer = walk.row.x == walk.high.x;
    walk.next = isLastOfLayer ? ivec2(walk.low.x, walk.row.y + 1) : ivec2(walk.row.x + 1, walk.row.y);
    // Distance of the row from the centre, and extent of the ball along the row
    vec2 edge = vec2(walk.row) / grid.inverseCellSize;
    vec2 away = greater(greater(edge - walk.position.yz, walk.position.yz - edge - 1.0 / grid.inverseCellSize), vec2(0.0));
    float reach2 = walk.reach2 - dot(away, away);
    if (reach2 < 0.0) {
        return true;
    }
    vec3 along = vec3(lesser(sqrt(reach2), walk.along), 0.0, 0.0);
    int left = cellOf(walk.position - along, grid).x;
    int right = cellOf(walk.position + along, grid).x;
    uint bucket = cellBucket(ivec3(left, walk.row), grid.bucketMask);
    uint last = bucket + uint(right - left);
    if (last > grid.bucketMask) {
        walk.wrapped = last - grid.bucketMask;
        last = grid.bucketMask;
    }
    first = cellStarts.at[bucket];
    end = cellStarts.at[last + 1u];
    return true;
}

// Is the photon at this position in the present row? Cells of several rows may share a bucket; their photons are met
// once for each row.
bool isOfRow(CellWalk walk, vec3 position, GridRecord grid) {
    return cellOf(position, grid).yz == walk.row;
}
#endif
