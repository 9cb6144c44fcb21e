// Rays through the 4-wide BVH with quantised boxes [Ylitie17]: one tree over the objects, one per mesh below it.
#ifndef HYALITE_BVH_GLSL
#define HYALITE_BVH_GLSL
#include "shared/limits.h"
#include "shared/path_records.h"
#include "lib/math.glsl"
#include "lib/shapes.glsl"

layout(constant_id = 0) const bool kHasMeshes = true;
// A scene of so few objects that trying each is faster than a hierarchy over them; 0: it has more.
layout(constant_id = 1) const uint kFewObjects = 0u;

// A ray as the box test wants it.
struct BoxRay {
    vec3 origin;
    vec3 inverse; // 1 / direction, finite
};

BoxRay boxRay(vec3 origin, vec3 direction) {
    // A component below 1e-18 is as good as zero; kept away from it, no product below is infinity times zero.
    vec3 safe = mix(direction, vec3(1.0e-18), lessThan(abs(direction), vec3(1.0e-18)));
    return BoxRay(origin, 1.0 / safe);
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

// Where the ray enters the node's four children, nearest first; kInfinity where it misses.
vec4 enterChildren(uint node, BoxRay ray, float tMax, out uvec4 children) {
    int base = int(node * kTexelsPerNode);
    uvec4 frame = texelFetch(nodeTable, base);
    children = texelFetch(nodeTable, base + 1);
    uvec4 low = texelFetch(nodeTable, base + 2); // lo x, lo y, lo z, hi x
    uvec2 high = texelFetch(nodeTable, base + 3).xy;
    vec3 scale = vec3(powerOfTwo(frame.w), powerOfTwo(frame.w >> 8u), powerOfTwo(frame.w >> 16u)) * ray.inverse;
    vec3 shift = (uintBitsToFloat(frame.xyz) - ray.origin) * ray.inverse;
    bvec3 backward = lessThan(ray.inverse, vec3(0.0));
    vec4 nearX = bytes(backward.x ? low.w : low.x) * scale.x + shift.x;
    vec4 farX = bytes(backward.x ? low.x : low.w) * scale.x + shift.x;
    vec4 nearY = bytes(backward.y ? high.x : low.y) * scale.y + shift.y;
    vec4 farY = bytes(backward.y ? low.y : high.x) * scale.y + shift.y;
    vec4 nearZ = bytes(backward.z ? high.y : low.z) * scale.z + shift.z;
    vec4 farZ = bytes(backward.z ? low.z : high.y) * scale.z + shift.z;
    vec4 tEnter = max(max(nearX, nearY), max(nearZ, vec4(0.0)));
    vec4 tLeave = min(min(farX, farY), farZ) * 1.000001; // rounding of the products above; the builder pads the rest
    bvec4 miss = greaterThan(tEnter, min(tLeave, vec4(tMax)));
    vec4 key = mix(tEnter, vec4(kInfinity), bvec4(miss.x || children.x == kNone, miss.y || children.y == kNone,
                                                  miss.z || children.z == kNone, miss.w || children.w == kNone));
    orderPair(key.x, key.y, children.x, children.y);
    orderPair(key.z, key.w, children.z, children.w);
    orderPair(key.x, key.z, children.x, children.z);
    orderPair(key.y, key.w, children.y, children.w);
    orderPair(key.y, key.z, children.y, children.z);
    return key;
}

// Puts the children that are hit on the stack, the nearest on top; the host has checked that the stack holds them.
void pushChildren(vec4 key, uvec4 children, inout uint stack[kTraversalStack], inout uint top) {
    if (key.w < kInfinity) {
        stack[top++] = children.w;
    }
    if (key.z < kInfinity) {
        stack[top++] = children.z;
    }
    if (key.y < kInfinity) {
        stack[top++] = children.y;
    }
    if (key.x < kInfinity) {
        stack[top++] = children.x;
    }
}

// Closest triangle of a mesh, or with `any` the first one found. The ray is in object space.
void traceMesh(uint root, uint object, vec3 o, vec3 d, bool any, inout Hit hit) {
    BoxRay ray = boxRay(o, d);
    uint stack[kTraversalStack];
    uint top = 0u;
    stack[top++] = root;
    while (top > 0u) {
        uint word = stack[--top];
        if ((word & kLeafBit) == 0u) {
            uvec4 children;
            vec4 key = enterChildren(word, ray, hit.t, children);
            pushChildren(key, children, stack, top);
            continue;
        }
        uint first = word & kLeafFirstMask;
        uint end = first + ((word & ~kLeafBit) >> kLeafCountShift);
        for (uint triangle = first; triangle < end; ++triangle) {
            if (intersectTriangle(o, d, triangle, hit.t, hit.uv)) {
                hit.object = object;
                hit.primitive = triangle;
                if (any) {
                    return;
                }
            }
        }
    }
}

void traceObject(uint object, Ray ray, bool any, inout Hit hit) {
    ObjectHeader header = objectHeader(object);
    vec4 texel0 = objectTexel(object, 0u);
    if (header.type == kShapeSphere) {
        if (intersectSphere(ray.origin, ray.direction, texel0, hit.t)) {
            hit.object = object;
            hit.primitive = 0u;
            hit.uv = vec2(0.0);
        }
        return;
    }
    vec4 texel1 = objectTexel(object, 1u);
    vec4 texel2 = objectTexel(object, 2u);
    if (header.type == kShapeQuad) {
        vec2 uv;
        if (intersectQuad(ray.origin, ray.direction, texel0, texel1, texel2, hit.t, uv)) {
            hit.object = object;
            hit.primitive = 0u;
            hit.uv = uv;
        }
        return;
    }
    if (kHasMeshes) {
        vec4 o = vec4(ray.origin, 1.0);
        vec3 origin = vec3(dot(texel0, o), dot(texel1, o), dot(texel2, o));
        vec3 direction = vec3(dot(texel0.xyz, ray.direction), dot(texel1.xyz, ray.direction),
                              dot(texel2.xyz, ray.direction));
        traceMesh(header.root, object, origin, direction, any, hit);
    }
}

// Descends the hierarchy over the objects.
void traceObjects(uint root, Ray ray, bool any, inout Hit hit) {
    BoxRay box = boxRay(ray.origin, ray.direction);
    uint stack[kTraversalStack];
    uint top = 0u;
    stack[top++] = root;
    while (top > 0u) {
        uint word = stack[--top];
        if ((word & kLeafBit) == 0u) {
            uvec4 children;
            vec4 key = enterChildren(word, box, hit.t, children);
            pushChildren(key, children, stack, top);
            continue;
        }
        uint first = word & kLeafFirstMask;
        uint end = first + ((word & ~kLeafBit) >> kLeafCountShift);
        for (uint object = first; object < end; ++object) {
            traceObject(object, ray, any, hit);
            if (any && hit.object != kNone) {
                return;
            }
        }
    }
}

// The closest hit along the ray, or with `any` some hit.
Hit traceScene(uint root, Ray ray, bool any) {
    Hit hit = Hit(ray.tMax, kNone, 0u, vec2(0.0));
    if (kFewObjects == 0u) {
        traceObjects(root, ray, any, hit);
        return hit;
    }
    for (uint object = 0u; object < kFewObjects && !(any && hit.object != kNone); ++object) {
        traceObject(object, ray, any, hit);
    }
    return hit;
}
#endif
