// Division of integers by way of floats. On lavapipe `/` and `%` divide lane after lane: a pair of them for each thread
// took a fifteenth of the time of tracing shadow rays.
#ifndef HYALITE_QUOTIENT_GLSL
#define HYALITE_QUOTIENT_GLSL

// a / b, rounded down, for 0 < b < 2^30 and a / b < 2^22; a - b * quotient(a, b) is the remainder. Three roundings leave
// the float's quotient less than one away from the true one, and with 2^23 added it is an integer in the last bits.
uint quotient(uint a, uint b) {
    uint q = floatBitsToUint(float(a) / float(b) + 8388608.0) & 0x007fffffu;
    int remainder = int(a - q * b);
    if (remainder < 0) {
        return q - 1u;
    }
    return remainder >= int(b) ? q + 1u : q; // the sum above rounds to the nearest
}
#endif
