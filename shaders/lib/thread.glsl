// The number of a thread in its dispatch. Commands::run lays groups out in rows when one row does not hold them.
#ifndef HYALITE_THREAD_GLSL
#define HYALITE_THREAD_GLSL
#extension GL_KHR_shader_subgroup_basic : require
#include "shared/limits.h"
#include "shared/pixel_order.h"
#include "shapes/quotient.glsl"

layout(local_size_x = kGroupSize) in;

// A software driver gives each of its threads one block of successive groups and takes nothing back from one that is
// behind: so their groups are dealt out in turn, and none gets the glass alone. gpu::Kernel sets it; 1 on a GPU.
layout(constant_id = 15) const uint kWorkers = 1u;

// The group's place in its row.
uint groupOfRow() {
    uint block = max(gl_NumWorkGroups.x / kWorkers, 1u);
    uint group = gl_WorkGroupID.x;
    bool isDealt = group < gl_NumWorkGroups.x / kWorkers * kWorkers; // the rest stays where it is
    uint worker = quotient(group, block);
    return isDealt ? (group - worker * block) * kWorkers + worker : group;
}

// The thread's place in its group. Lavapipe computes invocation ids by divisions lane by lane, but fills its subgroups
// one after the other, which not every driver does. Their size by their number: gl_SubgroupSize is compiled in as that
// of half the lanes where, in another thread, lavapipe happens to be looking up its vectors' width at that moment.
uint threadOfGroup() {
    return kWorkers > 1u ? gl_SubgroupID * quotient(kGroupSize, gl_NumSubgroups) + gl_SubgroupInvocationID
                         : gl_LocalInvocationIndex;
}

uint threadIndex() {
    return (gl_WorkGroupID.y * kGroupsPerRow + groupOfRow()) * gl_WorkGroupSize.x + threadOfGroup();
}

// The pixel of this thread; `width` of the picture, or 0 where threads take elements in their order.
uint threadPixel(uint width, uint count) {
    uint i = threadIndex();
    return width == 0u ? i : pixelOfThread(i, quotient(i, kTileSide * width), width, count);
}
#endif
