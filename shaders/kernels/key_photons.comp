#version 460
#extension GL_GOOGLE_include_directive : require
// Numbers the stored photons in slot order and writes the three sort keys of each.
// reads: photons, prefix sums of the marks
// writes: sort keys of the stored photons
// threads: photon slots
// computes: one key per axis, ordered as the coordinate
#include "shared/kernel_arguments.h"
#include "photons/kdtree.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { KeyPhotonsArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count || args.photons.at[i].surface == kNone) {
        return;
    }
    uint photon = args.numbers.at[i];
    args.slots.at[photon] = i;
    vec3 position = args.photons.at[i].position;
    uvec3 key = uvec3(orderedBits(position.x), orderedBits(position.y), orderedBits(position.z));
    args.keys.at[photon] = KeyedPhoton(key, photon);
    for (uint axis = 0u; axis < 3u; ++axis) {
        args.pairs.at[axis * args.stored + photon] = uvec2(key[axis], photon);
    }
}
