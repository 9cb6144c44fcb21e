// Printing from kernels, for experiments: debugPrint(value) takes a float, int, uint or a vector of two to four of
// them. `hyalite live` shows the output with kernel, line and thread; elsewhere it is discarded. A buffer of its own
// rather than debugPrintfEXT, which needs the validation layers and is slow.
#ifndef HYALITE_DEBUG_GLSL
#define HYALITE_DEBUG_GLSL
#extension GL_EXT_buffer_reference_uvec2 : require
#include "shared/debug_records.h"
#include "shared/path_records.h"
#include "shared/scene_records.h"
#include "lib/thread.glsl"

// One texel: the buffer's address in four parts of 16 bits, each exact in a float; 0: no listener.
layout(set = 0, binding = TABLE_DEBUG) uniform samplerBuffer debugTable;

uvec2 debugAddress() {
    uvec4 parts = uvec4(texelFetch(debugTable, 0));
    return uvec2(parts.x | parts.y << 16u, parts.z | parts.w << 16u);
}

// Is this the pixel last clicked?
bool debugPixel(uint pixel) {
    uvec2 address = debugAddress();
    return (address.x | address.y) != 0u && UintArray(address).at[kDebugPixel] == pixel;
}

void debugRecord(uint line, uint kind, uvec4 bits) {
    uvec2 address = debugAddress();
    if ((address.x | address.y) == 0u) {
        return;
    }
    UintArray words = UintArray(address);
    uint record = atomicAdd(words.at[kDebugCount], 1u);
    if (record >= words.at[kDebugRoom]) { // counted, though not stored
        return;
    }
    uint first = kDebugHeader + record * kDebugWords;
    words.at[first] = threadIndex();
    words.at[first + 1u] = line;
    words.at[first + 2u] = kind;
    words.at[first + 3u] = bits.x;
    words.at[first + 4u] = bits.y;
    words.at[first + 5u] = bits.z;
    words.at[first + 6u] = bits.w;
}

void debugPrintAt(uint line, float v) { debugRecord(line, kDebugFloat | 1u, uvec4(floatBitsToUint(v), 0u, 0u, 0u)); }
void debugPrintAt(uint line, vec2 v) { debugRecord(line, kDebugFloat | 2u, uvec4(floatBitsToUint(v), 0u, 0u)); }
void debugPrintAt(uint line, vec3 v) { debugRecord(line, kDebugFloat | 3u, uvec4(floatBitsToUint(v), 0u)); }
void debugPrintAt(uint line, vec4 v) { debugRecord(line, kDebugFloat | 4u, floatBitsToUint(v)); }
void debugPrintAt(uint line, int v) { debugRecord(line, kDebugInt | 1u, uvec4(uint(v), 0u, 0u, 0u)); }
void debugPrintAt(uint line, ivec2 v) { debugRecord(line, kDebugInt | 2u, uvec4(uvec2(v), 0u, 0u)); }
void debugPrintAt(uint line, ivec3 v) { debugRecord(line, kDebugInt | 3u, uvec4(uvec3(v), 0u)); }
void debugPrintAt(uint line, uint v) { debugRecord(line, kDebugUint | 1u, uvec4(v, 0u, 0u, 0u)); }
void debugPrintAt(uint line, uvec2 v) { debugRecord(line, kDebugUint | 2u, uvec4(v, 0u, 0u)); }
void debugPrintAt(uint line, uvec3 v) { debugRecord(line, kDebugUint | 3u, uvec4(v, 0u)); }
void debugPrintAt(uint line, uvec4 v) { debugRecord(line, kDebugUint | 4u, v); }

#define debugPrint(value) debugPrintAt(uint(__LINE__), value)
#endif
