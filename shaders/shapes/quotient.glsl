// Division of integers by way of floats. On lavapipe `/` and `%` divide lane after lane: a pair of them for each thread
// took a fifteenth of the time of tracing shadow rays.
#ifndef HYALITE_QUOTIENT_GLSL
#define HYALITE_QUOTIENT_GLSL

// a / b, rounded down, for 0 < b < 2^30 and a / b < 2^20; a - b * quotient(a, b) is the remainder. Two roundings and a
// division right to 2.5 ulp, as Vulkan asks, leave the float's quotient less than a half away from the true one; with
// 2^23 added it is the nearest integer, in the last bits: the one wanted, or one next to it.
uint quotient(uint a, uint b) {
    uint q = floatBitsToUint(float(a) / float(b) + 8388608.0) & 0x007fffffu;
    int remainder = int(a - q * b);
    if (remainder < 0) {
        return q - 1u;
    }
    return remainder >= int(b) ? q + 1u : q;
}
#endif
