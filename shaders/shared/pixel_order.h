// The order in which the threads of a dispatch take the pixels of a picture.
#ifndef HYALITE_SHARED_PIXEL_ORDER_H
#define HYALITE_SHARED_PIXEL_ORDER_H
#include "language.h"
SHARED_BEGIN

SHARED_CONSTANT kTileSide = 4u; // 16 pixels: threads of a subgroup see similar surfaces and diverge less

// The pixel that thread `i` of `count` takes: tile by tile along bands of kTileSide rows, row by row within a tile,
// then the rest of the band that fills no tile; the rows below the last whole band are in linear order. A permutation
// of 0 … count - 1 for any `width` > 0; `i` >= `count`: i itself. `band` is i / (kTileSide * width).
SHARED_FUNCTION uint pixelOfThread(uint i, uint band, uint width, uint count) {
    uint first = band * kTileSide * width;
    if (i >= count || count - first < kTileSide * width) {
        return i;
    }
    uint inBand = i - first;
    uint columns = width / kTileSide * kTileSide; // covered by tiles
    uint inTiles = columns * kTileSide;
    if (inBand < inTiles) {
        uint inTile = inBand % (kTileSide * kTileSide);
        return first + inTile / kTileSide * width + inBand / (kTileSide * kTileSide) * kTileSide + inTile % kTileSide;
    }
    uint rest = inBand - inTiles;
    uint restColumns = width - columns;
    return first + rest / restColumns * width + columns + rest % restColumns;
}

SHARED_END
#endif
