// Constructive solid geometry: walks the crossings of all leaves in order along the ray and keeps, for each leaf, one
// bit that says whether the ray is inside. The solid's surface is where the value of the tree changes.
//
// Crossings that lie within kPlaceLength (relative) of one another are one place: a piece of the solid, or a gap in it,
// that is thinner than this is not there. So coincident faces give a stable picture: they are crossed together, and
// what shows is the surface of the first leaf, in the order of the scene file, that decides.
#ifndef HYALITE_CSG_GLSL
#define HYALITE_CSG_GLSL
#include "lib/mesh.glsl"
#include "lib/solids.glsl"

const float kPlaceLength = 3.814697265625e-6; // 2^-18 of t or of the origin's largest coordinate: a few roundings

// What a leaf's walk along the ray knows.
struct LeafState {
    float t; // next crossing; kInfinity: none
    uint part;
    int winding;  // how often the ray is inside; analytic shapes: 0 or 1
    int entering; // what the next crossing adds to the winding
};

// The state after the crossing that `state` is at; `start`: at the beginning of the ray instead.
LeafState nextCrossing(uint leaf, Ray ray, LeafState state, bool start) {
    ObjectHeader header = objectHeader(leaf);
    float after = start ? 0.0 : state.t;
    if (isShape(header.type, kShapeMesh)) {
        vec3 o, d;
        toMeshSpace(leaf, ray, o, d);
        MeshCrossing next = nextMeshCrossing(header.root, o, d, after, start ? kNone : state.part, start);
        int winding = start ? next.winding : state.winding + state.entering;
        return LeafState(next.t, next.triangle, winding, next.entering);
    }
    Crossings crossings = solidCrossings(leaf, header.type, ray);
    int index = 0;
    while (index < 4 && crossings.t[index] <= after) {
        ++index;
    }
    if (index == 4) {
        return LeafState(kInfinity, 0u, 0, 0);
    }
    bool inside = (index & 1) != 0;
    return LeafState(crossings.t[index], crossings.part[index], inside ? 1 : 0, inside ? -1 : 1);
}

// The tree's value where bit i of `inside` says whether the point is in leaf i.
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

// Of the leaves whose bit changed at a place, the first that decides: whose change alone turns the value.
uint decidingLeaf(uvec4 program, uint steps, uint before, uint after, bool valueBefore) {
    uint changed = before ^ after;
    uint first = uint(findLSB(changed));
    for (uint rest = changed; rest != 0u; rest &= rest - 1u) {
        uint leaf = uint(findLSB(rest));
        uint bit = 1u << leaf;
        if (csgValue(program, steps, before ^ bit) != valueBefore ||
            csgValue(program, steps, after ^ bit) == valueBefore) {
            return leaf;
        }
    }
    return first;
}

void reportCrossing(uint leaf, vec2 crossing, Ray ray, inout Hit hit) {
    if (!(crossing.x < hit.t)) {
        return;
    }
    hit = Hit(crossing.x, leaf, floatBitsToUint(crossing.y), vec2(0.0));
    if (isShape(objectHeader(leaf).type, kShapeMesh)) {
        vec3 o, d;
        toMeshSpace(leaf, ray, o, d);
        hit.uv = triangleCoordinates(o, d, hit.primitive);
    }
}

void traceCsg(uint object, ObjectHeader header, Ray ray, inout Hit hit) {
    uvec2 leaves = floatBitsToUint(objectTexel(object, 0u).xy);
    uvec4 program = texelFetch(nodeTable, int(header.root));
    uint steps = 2u * leaves.y - 1u;
    LeafState states[kMaxCsgLeaves];
    vec2 crossed[kMaxCsgLeaves]; // (t, part as bits) of each leaf's last crossing

    uint inside = 0u;
    bool starting = true;
    uint before = 0u; // inside bits and value ahead of the place
    bool valueBefore = false;
    float placeEnd = 0.0;
    float lengthAtOrigin = maxComponent(abs(ray.origin));
    uint leaf = 0u;
    while (true) {
        LeafState state = nextCrossing(leaves.x + leaf, ray, states[leaf], starting);
        states[leaf] = state;
        uint bit = 1u << leaf;
        inside = state.winding != 0 ? inside | bit : inside & ~bit;
        if (starting && ++leaf < leaves.y) {
            continue;
        }
        if (starting) {
            starting = false;
            before = inside;
            valueBefore = csgValue(program, steps, inside);
        }

        float t = kInfinity;
        for (uint i = 0u; i < leaves.y; ++i) {
            if (states[i].t < t) {
                t = states[i].t;
                leaf = i;
            }
        }
        if (t > placeEnd) { // the place is complete
            if (inside != before && csgValue(program, steps, inside) != valueBefore) {
                uint surface = decidingLeaf(program, steps, before, inside, valueBefore);
                reportCrossing(leaves.x + surface, crossed[surface], ray, hit);
                return;
            }
            if (t >= hit.t) {
                return;
            }
            before = inside;
            placeEnd = t + kPlaceLength * max(t, lengthAtOrigin);
        }
        crossed[leaf] = vec2(t, uintBitsToFloat(states[leaf].part));
    }
}
#endif
