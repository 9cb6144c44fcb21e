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

// Area [m^2] of the part of the disc that lies on the surface around a point; the point's rays left `from` (see Ray).
// Exact on parallelograms; elsewhere the area of the whole disc.
float discArea(vec3 position, uint from, float radius) {
    float whole = kPi * radius * radius;
    uint object = (from & ~kRayInside) - 1u;
    if (!sceneHas(kShapeQuad) || from == 0u || !isShape(objectHeader(object).type, kShapeQuad)) {
        return whole;
    }
    vec4 uRow = objectTexel(object, 1u);
    vec4 vRow = objectTexel(object, 2u);
    vec2 uv = vec2(dot(uRow.xyz, position) + uRow.w, dot(vRow.xyz, position) + vRow.w);
    vec2 reach = radius * vec2(length(uRow.xyz), length(vRow.xyz));
    if (all(greaterThan(uv, reach)) && all(lessThan(uv, 1.0 - reach))) {
        return whole;
    }
    vec3 n = objectTexel(object, 0u).xyz;
    vec3 edge0 = cross(vRow.xyz, n);
    vec3 edge1 = cross(n, uRow.xyz);
    edge0 /= dot(uRow.xyz, edge0);
    edge1 /= dot(vRow.xyz, edge1);
    vec3 corner = -(uv.x * edge0 + uv.y * edge1);
    float twice = twiceTriangleInDisc(n, corner, corner + edge0, radius) +
                  twiceTriangleInDisc(n, corner + edge0, corner + edge0 + edge1, radius) +
                  twiceTriangleInDisc(n, corner + edge0 + edge1, corner + edge1, radius) +
                  twiceTriangleInDisc(n, corner + edge1, corner, radius);
    return clamp(0.5 * abs(twice), kLeastShareOfDisc * whole, whole);
}
#endif
