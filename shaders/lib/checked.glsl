// The checked build of the kernels: bounds checks on every array index (host/gpu/checked_kernels.h).
#ifndef HYALITE_CHECKED_GLSL
#define HYALITE_CHECKED_GLSL

#extension GL_EXT_buffer_reference_uvec2 : require

// Texel 0: number of buffers, and the address of the report. Then address and size in bytes of each buffer, in
// ascending order of address.
layout(set = 0, binding = 31) uniform usamplerBuffer checkTable;

// Number of indices out of bounds; for the first one its site, thread, index and array length.
layout(buffer_reference, std430, buffer_reference_align = 4) buffer CheckReport {
    uint outside;
    uint site;
    uint thread;
    uint index;
    uint size;
};
void reportOutside(uint index, uint length, uint site) {
    CheckReport report = CheckReport(texelFetch(checkTable, 0).yz);
    if (atomicAdd(report.outside, 1u) == 0u) {
        report.site = site;
        report.thread = (gl_WorkGroupID.y * 32768u + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
        report.index = index;
        report.size = length;
    }
}

// Difference of two 64-bit addresses [bytes].
uvec2 distanceBytes(uvec2 from, uvec2 to) {
    return uvec2(to.x - from.x, to.y - from.y - (to.x < from.x ? 1u : 0u));
}

// The index if it is within the array at this address, else 0; `behind`: the address of its second element.
int checkedIndex(uvec2 array, uvec2 behind, uint index, uint site) {
    uint stride = behind.x - array.x;
    uint low = 0u; // the last buffer that begins at or before the array; 0: none
    uint high = texelFetch(checkTable, 0).x + 1u;
    while (high - low > 1u) {
        uint middle = (low + high) / 2u;
        uvec2 begins = texelFetch(checkTable, int(middle)).xy;
        bool after = begins.y > array.y || (begins.y == array.y && begins.x > array.x);
        low = after ? low : middle;
        high = after ? middle : high;
    }
    uint length = 0u;
    if (low > 0u) {
        uvec4 buffer_ = texelFetch(checkTable, int(low));
        uvec2 into = distanceBytes(buffer_.xy, array);
        length = into.y == 0u && into.x < buffer_.z ? (buffer_.z - into.x) / stride : 0u;
    }
    if (index < length) {
        return int(index);
    }
    reportOutside(index, length, site);
    return 0;
}

uint checkedEntry(uint index, uint length, uint site) {
    if (index < length) {
        return index;
    }
    reportOutside(index, length, site);
    return 0u;
}

int checkedTexel(usamplerBuffer table, int index, uint site) {
    int length = textureSize(table);
    if (index >= 0 && index < length) {
        return index;
    }
    reportOutside(uint(index), uint(length), site);
    return 0;
}

int checkedTexel(samplerBuffer table, int index, uint site) {
    int length = textureSize(table);
    if (index >= 0 && index < length) {
        return index;
    }
    reportOutside(uint(index), uint(length), site);
    return 0;
}
#endif
