// Which elements of a queue there are, where its size stands on the device.
#ifndef HYALITE_QUEUE_GLSL
#define HYALITE_QUEUE_GLSL
#extension GL_EXT_buffer_reference_uvec2 : require
#include "shared/queue.h"
#include "lib/thread.glsl"

// Of the address of an array that a kernel may do without.
bool isSome(uvec2 address) {
    return any(notEqual(address, uvec2(0u)));
}

// How many elements have work; `most` without a size on the device.
uint liveCount(QueueSizeArray live, uint most) {
    return isSome(uvec2(live)) ? min(live.at[0].count, most) : most;
}

// The element that this thread takes, of `count` that may be `most`. They are the picture's pixels only where none is
// missing: then in the order of its tiles, with its `width`.
uint liveElement(uint width, uint count, uint most) {
    return threadPixel(count == most ? width : 0u, count);
}
#endif
