// The media around a path: a list of dielectric materials, packed into one word. `bits` per entry hold the number of a
// material; the innermost medium, which the path entered last, is in the lowest bits; unused entries have all bits set.
#ifndef HYALITE_SHARED_MEDIA_H
#define HYALITE_SHARED_MEDIA_H
#include "language.h"
SHARED_BEGIN

SHARED_CONSTANT kNoMedia = 0xffffffffu; // around a path that is inside nothing

// What the media of a scene ask of its kernels, as bits.
SHARED_CONSTANT kMediaIndices = 1u;  // a dielectric's index depends on the media around it: some have priorities
SHARED_CONSTANT kMediaMetals = 2u;   // metals may lie in dielectrics
SHARED_CONSTANT kMediaAbsorb = 4u;   // some dielectric absorbs
SHARED_CONSTANT kMediaThin = 8u;     // some glass is thin
SHARED_CONSTANT kMediaShadows = 16u; // shadow rays pass through some dielectric: it is thin or its index may match
SHARED_CONSTANT kMediaTouch = 32u;   // dielectrics touch other objects

// Bits of an entry that can hold the number of any of so many materials.
SHARED_FUNCTION uint mediumBits(uint materials) {
    uint bits = 1u;
    while (bits < 31u && (1u << bits) - 1u < materials) {
        ++bits;
    }
    return bits;
}

// Number of media that fit into a list.
SHARED_FUNCTION uint mediaCapacity(uint bits) {
    return 32u / bits;
}

SHARED_FUNCTION uint mediumMask(uint bits) {
    return 0xffffffffu >> (32u - bits);
}

// The material at the place in the list, 0 being the innermost; all bits set: none.
SHARED_FUNCTION uint mediumAt(uint media, uint place, uint bits) {
    uint entry = (media >> (place * bits)) & mediumMask(bits);
    return entry == mediumMask(bits) ? 0xffffffffu : entry;
}

// The list inside one more medium. A full list forgets the outermost; the host refuses scenes nested that deep.
SHARED_FUNCTION uint enterMedium(uint media, uint material, uint bits) {
    return (media << bits) | material;
}

// The list without the innermost entry of the material; unchanged if it has none.
SHARED_FUNCTION uint leaveMedium(uint media, uint material, uint bits) {
    for (uint place = 0u; place < mediaCapacity(bits); ++place) {
        if (mediumAt(media, place, bits) == material) {
            uint shift = place * bits;
            uint outer = (media >> shift >> bits) | ~(0xffffffffu >> shift >> bits);
            return (outer << shift) | (media & ((1u << shift) - 1u));
        }
    }
    return media;
}

SHARED_END
#endif
