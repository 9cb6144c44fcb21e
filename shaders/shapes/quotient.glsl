// Integer division by floats. On lavapipe `/` and `%` divide lane by lane: one pair per thread took a fifteenth of the
// time of tracing shadow rays.
#ifndef HYALITE_QUOTIENT_GLSL
#define HYALITE_QUOTIENT_GLSL

// a / b, rounded down, for 0 < b < 2^30 and a / b < 2^20; a - b * quotient(a, b) is the remainder. Two roundings and a
// division accurate to 2.5 ulp, as Vulkan requires, leave the float quotient less than a half from the true one; adding
// 2^23 rounds it to the nearest integer, in the low bits: the correct one or a neighbour.
uint quotient(uint a, uint b) {
    uint q = floatBitsToUint(float(a) / float(b) + 8388608.0) & 0x007fffffu;
    int remainder = int(a - q * b);
    if (remainder < 0) {
        return q - 1u;
    }
    return remainder >= int(b) ? q + 1u : q;
}
#endif
