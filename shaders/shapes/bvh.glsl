// Intersects rays with the nodes of the 4-wide hierarchy with quantised boxes [Ylitie17]; mesh.glsl and scene.glsl
// traverse it.
#ifndef HYALITE_BVH_GLSL
#define HYALITE_BVH_GLSL
#include "shared/limits.h"
#include "lib/math.glsl"
#include "shapes/stack.glsl"
#include "lib/tables.glsl"

// A ray prepared for the box test.
struct BoxRay {
    vec3 origin;
    vec3 inverse; // 1 / direction, finite
};

BoxRay boxRay(vec3 origin, vec3 direction) {
    return BoxRay(origin, 1.0 / awayFromZero(direction));
}

vec4 bytes(uint word) {
    return vec4(uvec4(word, word >> 8u, word >> 16u, word >> 24u) & 255u);
}

float powerOfTwo(uint exponent) {
    return uintBitsToFloat((exponent & 255u) << 23u);
}

void orderPair(inout float nearKey, inout float farKey, inout uint nearChild, inout uint farChild) {
    if (nearKey > farKey) {
        float key = nearKey;
        nearKey = farKey;
        farKey = key;
        uint child = nearChild;
        nearChild = farChild;
        farChild = child;
    }
}

// The stack words of children of these kinds.
uvec4 childWords(uvec4 kinds, uint firstNode, uint firstElement) {
    bvec4 inner = equal(kinds, uvec4(kInnerChild));
    uvec4 steps = mix(kinds, uvec4(1u << 16u), inner); // elements in the lower half, nodes in the upper
    uint two = steps.x + steps.y;
    uvec4 before = uvec4(0u, steps.x, two, two + steps.z);
    return mix(((kinds << kLeafCountShift) + (kLeafBit | firstElement)) + (before & 0xffffu),
               (before >> 16u) + firstNode, inner);
}

// Where the ray enters the node's four children, nearest first; kInfinity for a miss.
vec4 enterChildren(GeometryRecord node, BoxRay ray, float tMax, out uvec4 children) {
    uvec4 frame = node.a;
    uvec4 low = node.b; // lo x, lo y, lo z, hi x
    uvec4 high = node.c;
    uvec4 kinds = uvec4(frame.w >> 24u & 15u, frame.w >> 28u, high.zw >> kChildKindShift);
    children = childWords(kinds, high.z & kLeafFirstMask, high.w & kLeafFirstMask);
    vec3 scale = vec3(powerOfTwo(frame.w), powerOfTwo(frame.w >> 8u), powerOfTwo(frame.w >> 16u)) * ray.inverse;
    vec3 shift = (uintBitsToFloat(frame.xyz) - ray.origin) * ray.inverse;
    bvec3 backward = lessThan(ray.inverse, vec3(0.0));
    vec4 nearX = bytes(backward.x ? low.w : low.x) * scale.x + shift.x;
    vec4 farX = bytes(backward.x ? low.x : low.w) * scale.x + shift.x;
    vec4 nearY = bytes(backward.y ? high.x : low.y) * scale.y + shift.y;
    vec4 farY = bytes(backward.y ? low.y : high.x) * scale.y + shift.y;
    vec4 nearZ = bytes(backward.z ? high.y : low.z) * scale.z + shift.z;
    vec4 farZ = bytes(backward.z ? low.z : high.y) * scale.z + shift.z;
    vec4 tEnter = greater(greater(nearX, nearY), greater(nearZ, vec4(0.0)));
    vec4 tLeave = lesser(lesser(farX, farY), farZ) * 1.000001; // rounding of the products above; the builder pads the rest
    bvec4 miss = greaterThan(tEnter, lesser(tLeave, vec4(tMax)));
    vec4 key = mix(tEnter, vec4(kInfinity), bvec4(miss.x || kinds.x == 0u, miss.y || kinds.y == 0u,
                                                  miss.z || kinds.z == 0u, miss.w || kinds.w == 0u));
    orderPair(key.x, key.y, children.x, children.y);
    orderPair(key.z, key.w, children.z, children.w);
    orderPair(key.x, key.z, children.x, children.z);
    orderPair(key.y, key.w, children.y, children.w);
    orderPair(key.y, key.z, children.y, children.z);
    return key;
}

// The nearest child that the ray enters; pushes the others on the stack. kNone if it enters none.
uint nextChild(vec4 key, uvec4 children) {
    uint others = key.w < kInfinity ? 3u : key.z < kInfinity ? 2u : key.y < kInfinity ? 1u : 0u;
    pushEntries(others, children.yzw);
    return key.x < kInfinity ? children.x : kNone;
}
#endif
