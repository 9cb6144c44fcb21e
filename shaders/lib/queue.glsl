// Which elements of a queue to process; the queue's size is on the device.
#ifndef HYALITE_QUEUE_GLSL
#define HYALITE_QUEUE_GLSL
#extension GL_EXT_buffer_reference_uvec2 : require
#include "shared/queue.h"
#include "lib/thread.glsl"

// Is the address of an optional array set?
bool isSome(uvec2 address) {
    return any(notEqual(address, uvec2(0u)));
}

// Number of elements with work; `most` if there is no size on the device.
uint liveCount(QueueSizeArray live, uint most) {
    return isSome(uvec2(live)) ? min(live.at[0].count, most) : most;
}

// The element of this thread, of `count` elements (`most` at most). Only a full queue matches the picture's pixels:
// then threads follow the order of its tiles, with its `width`.
uint liveElement(uint width, uint count, uint most) {
    return threadPixel(count == most ? width : 0u, count);
}
#endif
