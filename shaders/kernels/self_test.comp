#version 460
#extension GL_GOOGLE_include_directive : require
// Known answers for selfTest() on the host: a long loop, texel fetches, and a struct in scalar layout.
// reads: –
// writes: known answers
// threads: 1024
// computes: checks the driver's loops, loads and struct layout
#include "lib/thread.glsl"
#include "shared/self_test.h"

layout(push_constant, scalar) uniform Push {
    SelfTestArguments args;
};
layout(set = 0, binding = 0) uniform samplerBuffer texels;

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    uint x = i;
    for (uint round = 0u; round < args.rounds; ++round) {
        x = selfTestRound(x);
    }
    args.answers.at[i].rounds = x;
    args.answers.at[i].texel = texelFetch(texels, int(i));
    args.answers.at[i].record = args.records.at[i];
}
