// The k photons nearest to a point, in a kd-tree or a grid of the photon table. Squared distances are computed
// identically everywhere and ties ordered by slot, so the result does not depend on the structure.
#ifndef HYALITE_NEAREST_GLSL
#define HYALITE_NEAREST_GLSL
#include "shared/limits.h"
#include "shared/photon_map.h"
#include "photons/grid.glsl"
#include "photons/photon.glsl"

// Most photons that a query may find: the private arrays are no longer than necessary.
layout(constant_id = 5) const uint kNearestCapacity = 64u;
layout(constant_id = 6) const uint kPhotonStructure = kPhotonTree;

struct NearestQuery {
    vec3 position;
    Tangent tangent; // only photons that landed on this side of the same surface count
    float radius;    // [m]
    uint nearest;  // number of photons, 1 … kNearestCapacity
    uint kinds;    // bit kPhoton… is set for every kind that counts
    uint depth;    // of the visible point
    uint maxDepth; // most segments of the photon's path and the camera's together
    bool records;  // the map holds irradiance records: they count within their own discs
};

// The photons found so far. Once there are as many as requested, a heap with the farthest on top.
float heapDistance2[kNearestCapacity];
uint heapPhoton[kNearestCapacity]; // number in the map
uint heapCount;
float heapReach2; // squared distance beyond which photons are ignored

bool isFarther(PhotonMapRecord map, float distance2, uint photon, float otherDistance2, uint other) {
    return distance2 > otherDistance2 ||
           (distance2 == otherDistance2 && map.order.at[photon] > map.order.at[other]);
}

// Sifts a photon down from `node` to its place in the heap of `count`.
void siftDown(PhotonMapRecord map, uint node, uint count, float distance2, uint photon) {
    while (2u * node + 1u < count) {
        uint child = 2u * node + 1u;
        if (child + 1u < count && isFarther(map, heapDistance2[child + 1u], heapPhoton[child + 1u],
                                            heapDistance2[child], heapPhoton[child])) {
            ++child;
        }
        if (!isFarther(map, heapDistance2[child], heapPhoton[child], distance2, photon)) {
            break;
        }
        heapDistance2[node] = heapDistance2[child];
        heapPhoton[node] = heapPhoton[child];
        node = child;
    }
    heapDistance2[node] = distance2;
    heapPhoton[node] = photon;
}

void makeHeap(PhotonMapRecord map) {
    for (uint node = heapCount / 2u; node > 0u; --node) {
        siftDown(map, node - 1u, heapCount, heapDistance2[node - 1u], heapPhoton[node - 1u]);
    }
}

// Sorts the photons found by distance.
void sortNearest(PhotonMapRecord map, NearestQuery query) {
    if (heapCount < query.nearest) {
        makeHeap(map);
    }
    for (uint last = heapCount; last > 1u; --last) {
        float distance2 = heapDistance2[last - 1u];
        uint photon = heapPhoton[last - 1u];
        heapDistance2[last - 1u] = heapDistance2[0];
        heapPhoton[last - 1u] = heapPhoton[0];
        siftDown(map, 0u, last - 1u, distance2, photon);
    }
}

// Does the photon `way` from the place, at this squared distance, count?
bool counts(NearestQuery query, vec3 way, float distance2, uint direction, uint surface) {
    if (!onSameSurface(query.tangent, way, surface)) {
        return false;
    }
    if (query.records) {
        float radius = recordRadius(direction);
        return distance2 <= radius * radius;
    }
    return onSameSide(query.tangent.normal, direction) && ((query.kinds >> photonKind(surface)) & 1u) != 0u &&
           photonLength(surface) + query.depth <= query.maxDepth;
}

// Inserts the photon if it counts and is among the nearest so far; `place`: its first texel.
void offer(PhotonMapRecord map, NearestQuery query, uint photon, vec4 place) {
    vec3 way = place.xyz - query.position;
    float distance2 = dot(way, way);
    bool full = heapCount == query.nearest;
    if (distance2 > heapReach2 || (full && !isFarther(map, heapDistance2[0], heapPhoton[0], distance2, photon))) {
        return;
    }
    vec4 rest = texelFetch(photonTable, int(2u * (map.base + photon) + 1u));
    if (!counts(query, way, distance2, floatBitsToUint(place.w), floatBitsToUint(rest.w))) {
        return;
    }
    if (full) {
        siftDown(map, 0u, heapCount, distance2, photon);
        heapReach2 = heapDistance2[0];
        return;
    }
    heapDistance2[heapCount] = distance2;
    heapPhoton[heapCount] = photon;
    if (++heapCount == query.nearest) {
        makeHeap(map);
        heapReach2 = heapDistance2[0];
    }
}

// Far children of the tree still to be visited, and the squared distances of the planes that they lie behind.
uint stackNode[kKdStack];
float stackDistance2[kKdStack];

// From a node to the next one to visit: the child on the side of the query, or the last far child left behind that is
// still within reach; `count` if there is none. Differences and squares round monotonically: a photon behind a plane is
// never nearer than the plane, even after rounding.
uint nextNode(uint node, vec3 position, vec4 place, uint count, float reach2, inout uint top) {
    uint axis = floatBitsToUint(place.w) >> kSplitAxisShift;
    vec3 way = place.xyz - position;
    float toPlane = axis == 0u ? way.x : (axis == 1u ? way.y : way.z);
    uint near = 2u * node + (toPlane > 0.0 ? 1u : 2u);
    uint far = 4u * node + 3u - near;
    float plane2 = toPlane * toPlane;
    if (far < count && plane2 <= reach2) {
        stackNode[top] = far;
        stackDistance2[top++] = plane2;
    }
    if (near < count) {
        return near;
    }
    while (top > 0u) {
        --top;
        if (stackDistance2[top] <= reach2) {
            return stackNode[top];
        }
    }
    return count;
}

void searchTree(PhotonMapRecord map, NearestQuery query) {
    uint top = 0u;
    uint node = 0u;
    while (node < map.count) {
        vec4 place = texelFetch(photonTable, int(2u * (map.base + node)));
        offer(map, query, node, place);
        node = nextNode(node, query.position, place, map.count, heapReach2, top);
    }
}

void searchGrid(PhotonMapRecord map, NearestQuery query) {
    CellWalk walk = walkCells(query.position, query.radius, vec3(query.radius), map.grid);
    uint photon = 0u, end = 0u;
    while (true) {
        if (photon >= end) {
            if (!nextRange(walk, map.grid, map.cellStarts, photon, end)) {
                break;
            }
            continue;
        }
        vec4 place = texelFetch(photonTable, int(2u * (map.base + photon)));
        if (isOfRow(walk, place.xyz, map.grid)) {
            offer(map, query, photon, place);
        }
        ++photon;
    }
}

void findNearest(PhotonMapRecord map, NearestQuery query) {
    heapCount = 0u;
    heapReach2 = query.radius * query.radius;
    if (kPhotonStructure == kPhotonTree) {
        searchTree(map, query);
    } else {
        searchGrid(map, query);
    }
}
#endif
