// The photon grid: space cut into cubic cells, cells hashed into buckets.
#ifndef HYALITE_GRID_GLSL
#define HYALITE_GRID_GLSL
#include "shared/grid.h"

ivec3 cellOf(vec3 position, GridRecord grid) {
    // Far outside any sensible scene cells merge; the distance test of a query still decides.
    return ivec3(clamp(floor(position * grid.inverseCellSize), vec3(-1.0e9), vec3(1.0e9)));
}

uint bucketOf(vec3 position, GridRecord grid) {
    return cellBucket(cellOf(position, grid), grid.bucketMask);
}
#endif
