// Counters of 64 bits on the device: two words, the lower first. With a counter of none, nothing is counted.
#ifndef HYALITE_COUNTER_GLSL
#define HYALITE_COUNTER_GLSL
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "shared/path_records.h"

// By threads of which few count.
void countAlone(UintArray counter, uint amount) {
    if (all(equal(uvec2(counter), uvec2(0u))) || amount == 0u) {
        return;
    }
    uint before = atomicAdd(counter.at[0], amount);
    if (before + amount < before) {
        atomicAdd(counter.at[1], 1u);
    }
}

// The sum over the threads of the subgroup that are here: one of them adds it.
void countAll(UintArray counter, uint amount) {
    uint sum = subgroupAdd(amount);
    if (subgroupElect()) {
        countAlone(counter, sum);
    }
}
#endif
