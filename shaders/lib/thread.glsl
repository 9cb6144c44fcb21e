// The number of a thread in its dispatch. Commands::run lays groups out in rows when one row does not hold them.
#ifndef HYALITE_THREAD_GLSL
#define HYALITE_THREAD_GLSL
#include "shared/limits.h"

layout(local_size_x = kGroupSize) in;

uint threadIndex() {
    return (gl_WorkGroupID.y * kGroupsPerRow + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
}
#endif
