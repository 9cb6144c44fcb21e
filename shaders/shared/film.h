// The film's sums as integer multiples of kFilmStep: addition is exact, so any number of machines may add passes in any
// order and get the same bits. Each pass's value is rounded to a step once, on its own.
#ifndef HYALITE_SHARED_FILM_H
#define HYALITE_SHARED_FILM_H
#include "language.h"
SHARED_BEGIN

// One step is 2^-44 (5.7e-14): radiances from 1e-6 up keep all digits of a float. 96 bits reach up to 2^52.
SHARED_CONSTANT kFilmFraction = 44u;

// 96 bits, unsigned.
struct FilmSum {
    uint low;
    uint middle;
    uint high;
};

struct FilmColor { // [W/(m^2 sr)], or the layer's own unit
    FilmSum red;
    FilmSum green;
    FilmSum blue;
};
DEVICE_ARRAY(FilmColor, FilmArray);

// Faults that keep a value from the film. It is counted and left out.
SHARED_CONSTANT kFilmNotANumber = 0u;
SHARED_CONSTANT kFilmInfinite = 1u;
SHARED_CONSTANT kFilmNegative = 2u;
SHARED_CONSTANT kFilmTooBright = 3u; // the value or the sum is 2^52 or more
SHARED_CONSTANT kFilmFaults = 4u;    // number of kinds; as a result: no fault

// Classifies the bits of a float.
SHARED_FUNCTION uint filmFault(uint bits) {
    uint magnitude = bits & 0x7fffffffu;
    if (magnitude >= 0x7f800000u) {
        return magnitude > 0x7f800000u ? kFilmNotANumber : kFilmInfinite;
    }
    if (magnitude != bits && magnitude != 0u) {
        return kFilmNegative;
    }
    return magnitude >> 23u >= 127u + 52u ? kFilmTooBright : kFilmFaults;
}

// The nearest number of steps to a float without fault, given its bits; halves round up.
SHARED_FUNCTION FilmSum filmSum(uint bits) {
    uint magnitude = bits & 0x7fffffffu;
    uint exponent = magnitude >> 23u;
    uint digits = (magnitude & 0x7fffffu) | 0x800000u; // times 2^(exponent - 150); subnormal numbers round to 0
    FilmSum sum;
    sum.low = 0u;
    sum.middle = 0u;
    sum.high = 0u;
    const uint unit = 150u - kFilmFraction; // exponent at which digits count steps
    if (exponent < unit) {
        uint drop = unit - exponent;
        sum.low = drop > 24u ? 0u : (digits + (1u << (drop - 1u))) >> drop;
        return sum;
    }
    uint shift = exponent - unit;
    uint bit = shift & 31u;
    uint less = digits << bit;
    uint more = bit == 0u ? 0u : digits >> (32u - bit);
    if (shift < 32u) {
        sum.low = less;
        sum.middle = more;
    } else if (shift < 64u) {
        sum.middle = less;
        sum.high = more;
    } else {
        sum.high = less;
    }
    return sum;
}

// Modulo 2^96: a sum that overflows is less than the addend.
SHARED_FUNCTION FilmSum filmAdd(FilmSum a, FilmSum b) {
    FilmSum sum;
    sum.low = a.low + b.low;
    uint carry = sum.low < a.low ? 1u : 0u;
    uint middle = a.middle + b.middle;
    sum.middle = middle + carry;
    carry = (middle < a.middle ? 1u : 0u) + (sum.middle < middle ? 1u : 0u);
    sum.high = a.high + b.high + carry;
    return sum;
}

SHARED_FUNCTION uint filmIsLess(FilmSum a, FilmSum b) {
    if (a.high != b.high) {
        return a.high < b.high ? 1u : 0u;
    }
    if (a.middle != b.middle) {
        return a.middle < b.middle ? 1u : 0u;
    }
    return a.low < b.low ? 1u : 0u;
}

// The bits of the nearest float; ties to even.
SHARED_FUNCTION uint filmValue(FilmSum sum) {
    uint zeros = 0u; // leading zeros
    for (uint word = 0u; word < 2u && sum.high == 0u; ++word) {
        sum.high = sum.middle;
        sum.middle = sum.low;
        sum.low = 0u;
        zeros += 32u;
    }
    if (sum.high == 0u) {
        return 0u;
    }
    uint shift = 0u;
    for (uint step = 16u; step > 0u; step >>= 1u) {
        if (sum.high << shift >> (32u - step) == 0u) {
            shift += step;
        }
    }
    zeros += shift;
    uint high = sum.high << shift;
    uint rest = sum.middle << shift | sum.low; // only whether it is zero matters
    if (shift > 0u) {
        high |= sum.middle >> (32u - shift);
    }
    uint digits = high >> 8u;
    uint below = high & 255u;
    uint up = below > 128u || (below == 128u && (rest != 0u || (digits & 1u) != 0u)) ? 1u : 0u;
    return ((95u - zeros + 127u - kFilmFraction) << 23u) + (digits & 0x7fffffu) + up;
}

SHARED_END
#endif
