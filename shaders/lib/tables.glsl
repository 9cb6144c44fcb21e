// The hot tables, read as vec4 texels (on lavapipe a texel load is several times faster than four words of a buffer).
#ifndef HYALITE_TABLES_GLSL
#define HYALITE_TABLES_GLSL
#include "lib/debug.glsl"
#include "shared/scene_records.h"

layout(set = 0, binding = TABLE_NODES) uniform usamplerBuffer nodeTable;
layout(set = 0, binding = TABLE_OBJECTS) uniform samplerBuffer objectTable;
layout(set = 0, binding = TABLE_TRIANGLES) uniform samplerBuffer triangleTable;
layout(set = 0, binding = TABLE_PHOTONS) uniform samplerBuffer photonTable;
layout(set = 0, binding = TABLE_TEXTURES) uniform samplerBuffer textureTable;
layout(set = 0, binding = TABLE_TEXTURE_COORDINATES) uniform samplerBuffer coordinateTable;

vec4 objectTexel(uint object, uint texel) {
    return texelFetch(objectTable, int(object * kTexelsPerObject + texel));
}

struct ObjectHeader {
    uint type;     // kShape…
    uint material; // kNone: absorbs
    uint light;    // kNone: does not emit
    uint root;     // mesh: root node
};

ObjectHeader objectHeader(uint object) {
    uvec4 bits = floatBitsToUint(objectTexel(object, 3u));
    return ObjectHeader(bits.x, bits.y, bits.z, bits.w);
}

vec3 triangleCorner(uint triangle, uint corner) {
    return texelFetch(triangleTable, int(triangle * kTexelsPerTriangle + corner)).xyz;
}
#endif
