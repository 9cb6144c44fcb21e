// Intersects rays with triangle meshes: the closest triangle, and for CSG the crossings one by one. In object space.
#ifndef HYALITE_MESH_GLSL
#define HYALITE_MESH_GLSL
#include "shared/path_records.h"
#include "shapes/bvh.glsl"

// The world-space ray with the same parameter: the direction is not unit.
void toMeshSpace(uint object, Ray ray, out vec3 o, out vec3 d) {
    vec4 row0 = objectTexel(object, 0u);
    vec4 row1 = objectTexel(object, 1u);
    vec4 row2 = objectTexel(object, 2u);
    vec4 origin = vec4(ray.origin, 1.0);
    o = vec3(dot(row0, origin), dot(row1, origin), dot(row2, origin));
    d = vec3(dot(row0.xyz, ray.direction), dot(row1.xyz, ray.direction), dot(row2.xyz, ray.direction));
}

// Edge functions from corners relative to the ray's origin: a shared edge gives both its triangles the same value with
// opposite sign, so no ray slips between them [Davidovic12]. The ray's direction need not be unit.
struct TriangleEdges {
    vec3 a; // first corner from the ray's origin
    vec3 normal;
    vec3 edgeA; // cross products of the edges opposite the corners: their dot product with the direction is the
    vec3 edgeB; // corner's weight
    vec3 edgeC;
};

TriangleEdges triangleEdges(vec3 o, GeometryRecord triangle) {
    vec3 a = uintBitsToFloat(triangle.a.xyz) - o;
    vec3 b = uintBitsToFloat(triangle.b.xyz) - o;
    vec3 c = uintBitsToFloat(triangle.c.xyz) - o;
    vec3 ca = a - c, ab = b - a, bc = c - b;
    return TriangleEdges(a, cross(ab, bc), cross(bc, c + b), cross(ca, a + c), cross(ab, b + a));
}

// The ray is o + (t - skipped) d.
bool intersectTriangle(vec3 o, vec3 d, float skipped, GeometryRecord triangle, inout float tMax, inout vec2 uv) {
    TriangleEdges e = triangleEdges(o, triangle);
    vec3 w = vec3(dot(e.edgeA, d), dot(e.edgeB, d), dot(e.edgeC, d));
    bool inside = all(greaterThanEqual(w, vec3(0.0))) || all(lessThanEqual(w, vec3(0.0)));
    float cosine = dot(e.normal, d);
    float t = skipped + dot(e.normal, e.a) / cosine;
    if (!inside || cosine == 0.0 || !(t > 0.0 && t < tMax)) {
        return false;
    }
    tMax = t;
    uv = w.yz / (w.x + w.y + w.z);
    return true;
}

// Barycentric coordinates of the second and third corner at the line's intersection with the triangle's plane.
vec2 triangleCoordinates(vec3 o, vec3 d, uint triangle) {
    TriangleEdges e = triangleEdges(o, geometryRecord(triangle));
    vec3 w = vec3(dot(e.edgeA, d), dot(e.edgeB, d), dot(e.edgeC, d));
    return w.yz / (w.x + w.y + w.z);
}

// The leaf's word without its first element; kNone if that was the last.
uint withoutFirst(uint leaf) {
    bool more = (leaf & ~kLeafBit) >= (2u << kLeafCountShift);
    return more ? leaf + 1u - (1u << kLeafCountShift) : kNone;
}

// Closest triangle of a mesh, or with `any` the first one found. Each round loads one record, a node or a triangle, so
// diverging lanes of a subgroup still load together. The ray is moved to where it enters the mesh's box: from far away
// the edge functions of small triangles, differences of large products, would lose precision.
void traceMesh(uint root, uint object, vec3 o, vec3 d, bool any, inout Hit hit) {
    BoxRay ray = boxRay(o, d);
    uint bottom = stackDepth;
    uvec4 children;
    vec4 key = enterChildren(geometryRecord(root), ray, hit.t, children);
    uint word = nextChild(key, children);
    if (word == kNone) {
        return;
    }
    float skipped = key.x;
    o += skipped * d;
    while (true) {
        GeometryRecord record = geometryRecord(word & kLeafFirstMask);
        if ((word & kLeafBit) == 0u) {
            key = enterChildren(record, ray, hit.t, children);
            word = nextChild(key, children);
        } else {
            if (intersectTriangle(o, d, skipped, record, hit.t, hit.uv)) {
                hit.object = object;
                hit.primitive = word & kLeafFirstMask;
                if (any) {
                    return;
                }
            }
            word = withoutFirst(word);
        }
        if (word == kNone) {
            if (stackDepth == bottom) {
                return;
            }
            word = popEntry();
        }
    }
}

// The sign of an edge function; exactly on the edge, that of the ray moved a little in x, less in y, still less in z.
// Both triangles see the same sign, so a line through the edge crosses exactly one of two triangles that face alike,
// and both or neither of two that do not [Edelsbrunner90].
bool isPositive(float weight, vec3 edge) {
    float w = weight != 0.0 ? weight : edge.x != 0.0 ? edge.x : edge.y != 0.0 ? edge.y : edge.z;
    return w > 0.0;
}

// One crossing of the line with a closed mesh, and the winding number from there on.
struct MeshCrossing {
    float t; // kInfinity: none
    uint triangle;
    int entering; // 1: enters, -1: leaves
    int winding;  // with `count`: triangles left minus triangles entered from there on
};

// The first crossing after (after, afterTriangle), in the order of t and then of the triangles' numbers.
MeshCrossing nextMeshCrossing(uint root, vec3 o, vec3 d, float after, uint afterTriangle, bool count) {
    MeshCrossing next = MeshCrossing(kInfinity, kNone, 0, 0);
    BoxRay ray = boxRay(o, d);
    uint bottom = stackDepth;
    uint word = root;
    while (true) {
        GeometryRecord record = geometryRecord(word & kLeafFirstMask);
        if ((word & kLeafBit) == 0u) {
            uvec4 children;
            vec4 key = enterChildren(record, ray, count ? kEndless : next.t, children);
            word = nextChild(key, children);
        } else {
            uint triangle = word & kLeafFirstMask;
            TriangleEdges e = triangleEdges(o, record);
            bool a = isPositive(dot(e.edgeA, d), e.edgeA);
            bool b = isPositive(dot(e.edgeB, d), e.edgeB);
            bool c = isPositive(dot(e.edgeC, d), e.edgeC);
            float t = dot(e.normal, e.a) / dot(e.normal, d);
            bool later = t > after || (t == after && afterTriangle != kNone && triangle > afterTriangle);
            if (a == b && b == c && later && t < kEndless) {
                int entering = a ? 1 : -1;
                next.winding -= entering;
                if (t < next.t || (t == next.t && triangle < next.triangle)) {
                    next = MeshCrossing(t, triangle, entering, next.winding);
                }
            }
            word = withoutFirst(word);
        }
        if (word == kNone) {
            if (stackDepth == bottom) {
                break;
            }
            word = popEntry();
        }
    }
    return next;
}
#endif
