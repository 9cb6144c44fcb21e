// The hot tables, read as vec4 texels (on lavapipe a texel load is several times faster than loading four words of a
// buffer).
#ifndef HYALITE_TABLES_GLSL
#define HYALITE_TABLES_GLSL
#include "lib/debug.glsl"
#include "shared/scene_records.h"

layout(set = 0, binding = TABLE_GEOMETRY) uniform usamplerBuffer geometryTable;
layout(set = 0, binding = TABLE_OBJECTS) uniform samplerBuffer objectTable;
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

// A triangle, its corners as bits, or a node of a hierarchy: see scene_records.h.
struct GeometryRecord {
    uvec4 a;
    uvec4 b;
    uvec4 c;
};

GeometryRecord geometryRecord(uint record) {
    int texel = int(record * kTexelsPerRecord);
    return GeometryRecord(texelFetch(geometryTable, texel), texelFetch(geometryTable, texel + 1),
                          texelFetch(geometryTable, texel + 2));
}
#endif
