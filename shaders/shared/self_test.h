// Input and output of self_test.comp, and the functions that host and device each evaluate.
#ifndef HYALITE_SHARED_SELF_TEST_H
#define HYALITE_SHARED_SELF_TEST_H
#include "language.h"
SHARED_BEGIN

// More rounds than lavapipe before Mesa 23 gives a loop: its loops end silently after 65 535.
SHARED_CONSTANT kSelfTestRounds = 100000u;

// Threads, records and texels of the test: two workgroups.
SHARED_CONSTANT kSelfTestCount = 128u;

// One round of the loop: a full-period linear congruential generator modulo 2^32, so that no two round counts below
// 2^32 leave the same value.
SHARED_FUNCTION uint selfTestRound(uint x) {
    return x * 1664525u + 1013904223u;
}

// A struct whose members have other offsets under std430 rules.
struct SelfTestRecord {
    uint first;
    vec3 second;
    uvec2 third;
    float fourth;
};
DEVICE_ARRAY(SelfTestRecord, SelfTestRecordArray);

struct SelfTestAnswer {
    uint rounds; // thread number after `rounds` rounds
    vec4 texel;
    SelfTestRecord record;
};
DEVICE_ARRAY(SelfTestAnswer, SelfTestAnswerArray);

struct SelfTestArguments {
    SelfTestRecordArray records;
    SelfTestAnswerArray answers; // out
    uint rounds;
    uint count;
};

SHARED_END
#endif
