// The thread's number in its dispatch. Commands::run lays groups out in rows if one row does not hold them all.
#ifndef HYALITE_THREAD_GLSL
#define HYALITE_THREAD_GLSL
#extension GL_KHR_shader_subgroup_basic : require
#include "shared/limits.h"
#include "shared/pixel_order.h"
#include "shapes/quotient.glsl"

layout(local_size_x = kGroupSize) in;

// A software driver gives each of its threads one block of successive groups and never rebalances. Groups are therefore
// interleaved among the blocks, so that no thread gets all the expensive pixels. gpu::Kernel sets it; 1 on a GPU.
layout(constant_id = 15) const uint kWorkers = 1u;

// The group's index in its row.
uint groupOfRow() {
    uint block = max(gl_NumWorkGroups.x / kWorkers, 1u);
    uint group = gl_WorkGroupID.x;
    bool isDealt = group < gl_NumWorkGroups.x / kWorkers * kWorkers; // the remainder keeps its place
    uint worker = quotient(group, block);
    return isDealt ? (group - worker * block) * kWorkers + worker : group;
}

// The thread's index in its group. Lavapipe computes invocation ids by divisions lane by lane, but fills its subgroups
// in order, which not every driver does. The subgroup size is computed from the number of subgroups: gl_SubgroupSize is
// compiled in as half the lanes if, in another thread, lavapipe happens to be looking up its vector width at that
// moment.
uint threadOfGroup() {
    return kWorkers > 1u ? gl_SubgroupID * quotient(kGroupSize, gl_NumSubgroups) + gl_SubgroupInvocationID
                         : gl_LocalInvocationIndex;
}

uint threadIndex() {
    return (gl_WorkGroupID.y * kGroupsPerRow + groupOfRow()) * gl_WorkGroupSize.x + threadOfGroup();
}

// The pixel of this thread; `width` of the picture, or 0 if threads take elements in linear order.
uint threadPixel(uint width, uint count) {
    uint i = threadIndex();
    return width == 0u ? i : pixelOfThread(i, quotient(i, kTileSide * width), width, count);
}
#endif
