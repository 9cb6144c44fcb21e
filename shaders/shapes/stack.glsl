// The traversal stack of the hierarchies that a ray is in: the one over objects, and on top of it that of a mesh. Each
// traversal remembers the depth at which it began, and ends there.
//
// On a device without scattered stores to private memory (lavapipe) an indexed store costs a branch for every lane.
// Therefore the topmost entries are variables that are shifted, and only the rare overflow goes to an array. The
// variables are global, because function parameters are copied.
#ifndef HYALITE_STACK_GLSL
#define HYALITE_STACK_GLSL
#include "shared/limits.h"
#include "lib/specialization.glsl"

uint stackDepth = 0u; // entries
uint stackTop0 = 0u;  // the topmost
uint stackTop1 = 0u;
uint stackTop2 = 0u;
uint stackTop3 = 0u;
uint stackTop4 = 0u;
uint stackTop5 = 0u;
const bool kAllInTops = kStackEntries <= kStackTops;
uint stackRest[kAllInTops ? 1u : kStackEntries - kStackTops]; // the entries below, the lowest first

// Pushes the first `count` (0 to 3) of the entries, the first of them on top.
void pushEntries(uint count, uvec3 entries) {
    bool one = (count & 1u) != 0u;
    bool two = (count & 2u) != 0u;
    if (!kAllInTops && stackDepth + count > kStackTops) {
        if (count == 3u && stackDepth >= kStackTops - 2u) {
            stackRest[stackDepth - (kStackTops - 2u)] = stackTop3;
        }
        if (two && stackDepth >= kStackTops - 1u) {
            stackRest[stackDepth - (kStackTops - 1u)] = stackTop4;
        }
        if (count != 0u && stackDepth >= kStackTops) {
            stackRest[stackDepth - kStackTops] = stackTop5;
        }
    }
    stackDepth += count;
    stackTop5 = one ? stackTop4 : stackTop5;
    stackTop4 = one ? stackTop3 : stackTop4;
    stackTop3 = one ? stackTop2 : stackTop3;
    stackTop2 = one ? stackTop1 : stackTop2;
    stackTop1 = one ? stackTop0 : stackTop1;
    stackTop5 = two ? stackTop3 : stackTop5;
    stackTop4 = two ? stackTop2 : stackTop4;
    stackTop3 = two ? stackTop1 : stackTop3;
    stackTop2 = two ? stackTop0 : stackTop2;
    stackTop0 = count >= 1u ? entries.x : stackTop0;
    stackTop1 = count >= 2u ? entries.y : stackTop1;
    stackTop2 = count >= 3u ? entries.z : stackTop2;
}

// Pops the topmost entry; there must be one.
uint popEntry() {
    uint entry = stackTop0;
    stackTop0 = stackTop1;
    stackTop1 = stackTop2;
    stackTop2 = stackTop3;
    stackTop3 = stackTop4;
    stackTop4 = stackTop5;
    --stackDepth;
    if (!kAllInTops && stackDepth >= kStackTops) {
        stackTop5 = stackRest[stackDepth - kStackTops];
    }
    return entry;
}
#endif
