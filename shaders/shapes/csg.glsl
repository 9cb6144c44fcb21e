// Constructive solid geometry: walks the crossings of all leaves in order along the ray and keeps one bit per leaf that
// says whether the ray is inside it. The solid's surface is where the value of the tree changes.
//
// A ray from afar is walked from a point near the solid, where single precision tells its crossings apart. Crossings
// within kPlaceLength of one another, relative to their distance from where the walk starts, form one place: a piece of the solid, or a gap in it, that is
// thinner than a place is ignored. This makes coincident faces render stably: they are crossed together, and the
// visible surface, at the first of these crossings, belongs to the first leaf, in the order of the scene file, that is
// crossed in the same sense as the solid and decides its value.
#ifndef HYALITE_CSG_GLSL
#define HYALITE_CSG_GLSL
#include "shapes/mesh.glsl"
#include "shapes/solids.glsl"

const float kLongStart = 64.0; // distance, in place lengths, within which the ray waits for its known side to be confirmed

// State of one leaf's walk along the ray.
struct LeafState {
    float t; // next crossing; kInfinity: none
    uint part;
    int winding;  // winding number of the ray; analytic shapes: 0 or 1
    int entering; // what the next crossing adds to the winding
    uint behind;  // part of the previous crossing; kNone: unknown
};

// The states of a solid's leaves, in their order. On lavapipe a store to an array at a dynamic index costs a branch for
// every lane; a store in an unrolled loop over the whole array costs a blend.
float leafT[kCsgLeaves];
uint leafPart[kCsgLeaves];
int leafWinding[kCsgLeaves]; // of meshes
int leafEntering[kCsgLeaves];
uint leafCrossed[kCsgLeaves]; // part of the last crossing

void setLeaf(uint leaf, LeafState state) {
    for (uint i = 0u; i < kCsgLeaves; ++i) {
        if (i == leaf) {
            leafT[i] = state.t;
            leafPart[i] = state.part;
            if (sceneHas(kShapeMesh)) {
                leafWinding[i] = state.winding;
                leafEntering[i] = state.entering;
            }
        }
    }
}

void setCrossed(uint leaf, uint part) {
    for (uint i = 0u; i < kCsgLeaves; ++i) {
        leafCrossed[i] = i == leaf ? part : leafCrossed[i];
    }
}

// The state of leaf `i` of a solid whose first leaf is `first`, after its present crossing; with `start`, at the ray
// parameter `startsAt` instead.
LeafState nextCrossing(uint first, uint i, Ray ray, bool start, float startsAt) {
    uint leaf = first + i;
    ObjectHeader header = objectHeader(leaf);
    float after = start ? startsAt : leafT[i];
    if (isShape(header.type, kShapeMesh)) {
        vec3 o, d;
        toMeshSpace(leaf, ray, o, d);
        MeshCrossing next = nextMeshCrossing(header.root, o, d, after, start ? kNone : leafPart[i], start);
        int winding = start ? next.winding : leafWinding[i] + leafEntering[i];
        return LeafState(next.t, next.triangle, winding, next.entering, kNone);
    }
    Crossings crossings = solidCrossings(leaf, header.type, ray);
    int index = 0;
    while (index < 4 && crossings.t[index] <= after) {
        ++index;
    }
    bool inside = (index & 1) != 0;
    return LeafState(index < 4 ? crossings.t[index] : kInfinity, index < 4 ? crossings.part[index] : 0u,
                     inside ? 1 : 0, inside ? -1 : 1, index > 0 ? crossings.part[index - 1] : kNone);
}

// The tree's value; bit i of `inside` says whether the point is in leaf i.
bool csgValue(uvec4 program, uint steps, uint inside) {
    uint stack = 0u; // the top is bit 0
    for (uint i = 0u; i < steps; ++i) {
        uint code = (program[i >> 4u] >> (2u * (i & 15u))) & 3u;
        if (code == kCsgLeaf) {
            stack = (stack << 1u) | (inside & 1u);
            inside >>= 1u;
        } else {
            uint right = stack & 1u;
            uint left = (stack >> 1u) & 1u;
            uint value = code == kCsgUnion ? left | right : code == kCsgIntersection ? left & right : left & ~right;
            stack = ((stack >> 2u) << 1u) | (value & 1u);
        }
    }
    return (stack & 1u) != 0u;
}

// The first candidate whose bit alone changes the tree's value before or after a place; if none does, the first
// candidate.
uint decidingLeaf(uvec4 program, uint steps, uint candidates, uint before, uint after) {
    bool valueBefore = csgValue(program, steps, before);
    bool valueAfter = csgValue(program, steps, after);
    for (uint rest = candidates; rest != 0u; rest &= rest - 1u) {
        uint leaf = uint(findLSB(rest));
        uint bit = 1u << leaf;
        if (csgValue(program, steps, before ^ bit) != valueBefore ||
            csgValue(program, steps, after ^ bit) != valueAfter) {
            return leaf;
        }
    }
    return uint(findLSB(candidates));
}

// `t` is the parameter of `ray`, which starts `skipped` behind the ray that is traced.
void reportSurface(uint leaf, float t, uint part, bool enters, Ray ray, float skipped, inout Hit hit) {
    if (!(skipped + t < hit.t)) {
        return;
    }
    hit = Hit(max(skipped + t, kTiny), leaf, part | (enters ? kHitEnters : 0u), vec2(0.0));
    if (isShape(objectHeader(leaf).type, kShapeMesh)) {
        vec3 o, d;
        toMeshSpace(leaf, ray, o, d);
        hit.uv = triangleCoordinates(o, d, part);
    }
}

// How far the walk may skip along a ray from afar: to two radii before the middle of the sphere around the solid. 0 for
// rays from nearer than kFarFromSolid radii, and where the solid is endless.
const float kFarFromSolid = 16.0;

float lengthToSolid(uint object, Ray ray) {
    vec4 sphere = objectTexel(object, 1u);
    float toSphere = dot(sphere.xyz - ray.origin, ray.direction) - 2.0 * sphere.w;
    return toSphere > kFarFromSolid * sphere.w ? toSphere : 0.0;
}

void traceCsg(uint object, ObjectHeader header, Ray ray, inout Hit hit) {
    float skipped = lengthToSolid(object, ray);
    if (skipped > 0.0) {
        ray.origin = alongRay(ray.origin, vec3(0.0), ray.direction, skipped);
    }
    float tMax = hit.t - skipped;
    vec4 head = objectTexel(object, 0u);
    uvec2 leaves = floatBitsToUint(head.xy);
    uvec4 program = texelFetch(geometryTable, int(header.root));
    uint steps = 2u * leaves.y - 1u;
    uint reversed = 0u; // bits of the leaves whose inside lies outside the solid

    uint inside = 0u;
    bool starting = true;
    uint before = 0u; // inside bits and value before the place
    bool valueBefore = false;
    // A ray that leaves this object starts within a place and knows the value before it
    Start start = startAt(object, ray.from);
    float around = greater(startLength(ray.origin), kPlaceLength * head.z);
    float placeStart = 0.0;
    float placeEnd = start.known ? around : 0.0;
    uint leaf = 0u;
    while (true) {
        LeafState state = nextCrossing(leaves.x, leaf, ray, starting, start.known ? -around : 0.0);
        setLeaf(leaf, state);
        uint bit = 1u << leaf;
        inside = state.winding != 0 ? inside | bit : inside & ~bit;
        if (starting) {
            uint type = objectHeader(leaves.x + leaf).type;
            bool isAway = state.winding == 0 && state.t >= tMax;
            if (isAway && (type & kShapeRequired) != 0u && !(start.known && start.inside)) {
                return; // so the solid is absent up to the hit
            }
            setCrossed(leaf, state.behind);
            reversed |= (type & kShapeReversed) != 0u ? bit : 0u;
            if (++leaf < leaves.y) {
                continue;
            }
            starting = false;
            before = inside;
            valueBefore = start.known ? start.inside : csgValue(program, steps, inside);
        }

        float t = kInfinity;
        for (uint i = 0u; i < leaves.y; ++i) {
            if (leafT[i] < t) {
                t = leafT[i];
                leaf = i;
            }
        }
        // The known side may be confirmed only a little beyond the ray's start
        bool waits = start.known && placeStart == 0.0 && t <= kLongStart * around &&
                     csgValue(program, steps, inside) != start.inside;
        bool isLast = t == kInfinity; // no leaf is crossed again: ends a place that is too long to end by itself
        if (isLast || (t > placeEnd && !waits)) { // the place is complete
            bool value = csgValue(program, steps, inside);
            if (value != valueBefore) {
                // If nothing was crossed, the leaf that alone explains the change: the ray slips out along its surface
                uint candidates = before != inside ? before ^ inside : ~0u >> (kMaxCsgLeaves - leaves.y);
                candidates &= (value ? inside : ~inside) ^ reversed; // those crossed in the same sense as the solid
                uint surface = decidingLeaf(program, steps, candidates, before, inside);
                if (candidates != 0u && leafCrossed[surface] != kNone) {
                    reportSurface(leaves.x + surface, placeStart, leafCrossed[surface], value, ray, skipped,
                                  hit);
                    return;
                }
            }
            if (isLast || t >= tMax) {
                return;
            }
            before = inside;
            valueBefore = value;
            placeStart = t;
            placeEnd = t + max(kPlaceLength * t, around);
        }
        setCrossed(leaf, leafPart[leaf]);
    }
}
#endif
