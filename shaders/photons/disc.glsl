// How much of the disc around a point lies on the point's surface. Photons land only there: dividing by the whole
// disc's area would darken every edge.
#ifndef HYALITE_DISC_GLSL
#define HYALITE_DISC_GLSL
#include "shared/path_records.h"
#include "lib/math.glsl"
#include "lib/specialization.glsl"
#include "lib/tables.glsl"

// Lower bound on that share: on strips narrower than this, a thousandth of the disc, the density is not raised further.
const float kLeastShareOfDisc = 0.0009765625;

// Twice the signed area that the disc around the origin shares with the triangle (origin, a, b), in the plane with unit
// normal n; and of the sector from a to b.
float twiceSector(vec3 n, vec3 a, vec3 b, float radius) {
    return radius * radius * 2.0 * kPi * angleInTurns(dot(n, cross(a, b)), dot(a, b));
}

float twiceTriangleInDisc(vec3 n, vec3 a, vec3 b, float radius) {
    vec3 way = b - a;
    float length2 = dot(way, way);
    float along = -dot(a, way) / length2;
    float root2 = along * along - (dot(a, a) - radius * radius) / length2;
    float root = sqrt(max(0.0, root2));
    float first = clamp(along - root, 0.0, 1.0);
    float last = clamp(along + root, 0.0, 1.0);
    if (first >= last) { // the side misses the disc
        return twiceSector(n, a, b, radius);
    }
    vec3 p = a + first * way;
    vec3 q = a + last * way;
    float area = dot(n, cross(p, q));
    area += first > 0.0 ? twiceSector(n, a, p, radius) : 0.0;
    area += last < 1.0 ? twiceSector(n, q, b, radius) : 0.0;
    return area;
}

// Area [m^2] that discs of the radii r and s share, their centres d apart: two sectors less the kite of the centres and
// the crossings of the rims.
float sharedArea(float r, float s, float d) {
    if (d + r <= s || d + s <= r) {
        return kPi * min(r, s) * min(r, s);
    }
    float a = 0.5 * (d + (r - s) * (r + s) / d); // from the first centre to the chord
    float h = sqrt(max(0.0, (r - a) * (r + a))); // half of the chord
    return 2.0 * kPi * (r * r * angleInTurns(h, a) + s * s * angleInTurns(h, d - a)) - d * h;
}

// The edge of the flat shape under a point, if it cuts the disc around it. Photons beyond it lie on another object, in the
// same plane or not: neither they nor the part of the disc there count.
struct Edge {
    bool isRound; // of a disk, else of a parallelogram
    bool cuts;    // false: all of the disc lies on the shape, or the shape is not one of these
    vec4 uRow;    // coordinates in the plane: of a disk from -1 to 1, of a parallelogram from 0 to 1
    vec4 vRow;
};

vec2 coordinatesOn(Edge edge, vec3 position) {
    return vec2(dot(edge.uRow.xyz, position) + edge.uRow.w, dot(edge.vRow.xyz, position) + edge.vRow.w);
}

// The point's rays left `from` (see Ray). A disk stretched to an ellipse has no edge here.
Edge edgeAround(vec3 position, uint from, float radius) {
    Edge edge = Edge(false, false, vec4(0.0), vec4(0.0));
    uint object = (from & ~kRayInside) - 1u;
    if (!(sceneHas(kShapeQuad) || sceneHas(kShapeDisk)) || from == 0u) {
        return edge;
    }
    uint type = objectHeader(object).type;
    edge.isRound = isShape(type, kShapeDisk);
    if (!edge.isRound && !isShape(type, kShapeQuad)) {
        return edge;
    }
    edge.uRow = objectTexel(object, 1u);
    edge.vRow = objectTexel(object, 2u);
    vec2 uv = coordinatesOn(edge, position);
    if (edge.isRound) {
        float u2 = dot(edge.uRow.xyz, edge.uRow.xyz);
        float v2 = dot(edge.vRow.xyz, edge.vRow.xyz);
        bool isCircle = abs(dot(edge.uRow.xyz, edge.vRow.xyz)) + abs(u2 - v2) < 1.0e-4 * u2;
        edge.cuts = isCircle && length(uv) + radius * sqrt(u2) > 1.0;
    } else {
        vec2 reach = radius * vec2(length(edge.uRow.xyz), length(edge.vRow.xyz));
        edge.cuts = !(all(greaterThan(uv, reach)) && all(lessThan(uv, 1.0 - reach)));
    }
    return edge;
}

// Does a photon lie on the shape?
bool isOnShape(Edge edge, vec3 position) {
    if (!edge.cuts) {
        return true;
    }
    vec2 uv = coordinatesOn(edge, position);
    const float rounding = 1.0e-6;
    return edge.isRound ? dot(uv, uv) <= 1.0 + rounding
                        : all(greaterThanEqual(uv, vec2(-rounding))) && all(lessThanEqual(uv, vec2(1.0 + rounding)));
}

// Area [m^2] of the part of the disc around a point that lies on the shape; `normal`: of the plane.
float discArea(Edge edge, vec3 position, vec3 normal, float radius) {
    float whole = kPi * radius * radius;
    if (!edge.cuts) {
        return whole;
    }
    vec2 uv = coordinatesOn(edge, position);
    if (edge.isRound) {
        float rim = 1.0 / sqrt(dot(edge.uRow.xyz, edge.uRow.xyz));
        return clamp(sharedArea(radius, rim, rim * length(uv)), kLeastShareOfDisc * whole, whole);
    }
    vec3 edge0 = cross(edge.vRow.xyz, normal);
    vec3 edge1 = cross(normal, edge.uRow.xyz);
    edge0 /= dot(edge.uRow.xyz, edge0);
    edge1 /= dot(edge.vRow.xyz, edge1);
    vec3 corner = -(uv.x * edge0 + uv.y * edge1);
    float twice = twiceTriangleInDisc(normal, corner, corner + edge0, radius) +
                  twiceTriangleInDisc(normal, corner + edge0, corner + edge0 + edge1, radius) +
                  twiceTriangleInDisc(normal, corner + edge0 + edge1, corner + edge1, radius) +
                  twiceTriangleInDisc(normal, corner + edge1, corner, radius);
    return clamp(0.5 * abs(twice), kLeastShareOfDisc * whole, whole);
}
#endif
