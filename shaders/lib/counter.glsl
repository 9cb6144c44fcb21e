// 64-bit counters on the device: two words, the lower first. A null counter counts nothing.
#ifndef HYALITE_COUNTER_GLSL
#define HYALITE_COUNTER_GLSL
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "shared/path_records.h"

// Adds atomically per thread; for kernels where few threads count.
void countAlone(UintArray counter, uint amount) {
    if (all(equal(uvec2(counter), uvec2(0u))) || amount == 0u) {
        return;
    }
    uint before = atomicAdd(counter.at[0], amount);
    if (before + amount < before) {
        atomicAdd(counter.at[1], 1u);
    }
}

// Adds the sum over the active threads of the subgroup, by one atomic operation.
void countAll(UintArray counter, uint amount) {
    uint sum = subgroupAdd(amount);
    if (subgroupElect()) {
        countAlone(counter, sum);
    }
}
#endif
