// Samples one of several elements by their cdf: a row of the environment, a triangle of a mesh.
#ifndef HYALITE_CHOOSE_GLSL
#define HYALITE_CHOOSE_GLSL
#include "shared/scene_records.h"

struct Choice {
    uint index;
    float rest; // x's relative position within the element: again uniform in [0, 1]
};

// Among `count` elements from `first` on, the first whose cdf exceeds x in [0, 1).
Choice choose(CdfArray cdfs, uint first, uint count, float x) {
    uint low = first, high = first + count - 1u;
    while (low < high) {
        uint middle = (low + high) / 2u;
        if (x < cdfs.at[middle]) {
            high = middle;
        } else {
            low = middle + 1u;
        }
    }
    float before = low > first ? cdfs.at[low - 1u] : 0.0;
    return Choice(low - first, (x - before) / (cdfs.at[low] - before));
}
#endif
