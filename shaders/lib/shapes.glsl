// Ray against one shape: the nearest t in (0, tMax), or none. Each returns true and lowers tMax where it hits.
#ifndef HYALITE_SHAPES_GLSL
#define HYALITE_SHAPES_GLSL
#include "lib/tables.glsl"

// `d` is unit. The discriminant is taken from the distance of centre and line, and the nearer root from the product
// of both, so neither loses digits far away or on the surface [Haines19].
bool intersectSphere(vec3 o, vec3 d, vec4 sphere, inout float tMax) {
    vec3 fromCenter = o - sphere.xyz;
    float radius = sphere.w;
    float b = dot(fromCenter, d);
    vec3 offLine = fromCenter - b * d;
    float discriminant = radius * radius - dot(offLine, offLine);
    if (discriminant < 0.0) {
        return false;
    }
    float distance = length(fromCenter);
    float c = (distance - radius) * (distance + radius);
    float root = sqrt(discriminant);
    float q = b > 0.0 ? -b - root : root - b;
    float t0 = q == 0.0 ? 0.0 : c / q;
    float tNear = min(t0, q);
    float tFar = max(t0, q);
    float t = tNear > 0.0 ? tNear : tFar;
    if (!(t > 0.0 && t < tMax)) {
        return false;
    }
    tMax = t;
    return true;
}

// The texels of a quad are its plane and two affine coordinates; see scene_records.h.
bool intersectQuad(vec3 o, vec3 d, vec4 plane, vec4 uRow, vec4 vRow, inout float tMax, out vec2 uv) {
    float t = (plane.w - dot(plane.xyz, o)) / dot(plane.xyz, d);
    vec3 p = o + t * d;
    uv = vec2(dot(uRow.xyz, p) + uRow.w, dot(vRow.xyz, p) + vRow.w);
    if (!(t > 0.0 && t < tMax) || any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) {
        return false;
    }
    tMax = t;
    return true;
}

// Edge functions from corners relative to the ray: a shared edge gives the same value with opposite sign to both its
// triangles, so no ray slips between them [Davidovic12]. `d` need not be unit.
bool intersectTriangle(vec3 o, vec3 d, uint triangle, inout float tMax, inout vec2 uv) {
    vec3 a = triangleCorner(triangle, 0u) - o;
    vec3 b = triangleCorner(triangle, 1u) - o;
    vec3 c = triangleCorner(triangle, 2u) - o;
    vec3 ca = a - c, ab = b - a, bc = c - b;
    float wb = dot(cross(ca, a + c), d); // weights of the corners opposite the edges
    float wc = dot(cross(ab, b + a), d);
    float wa = dot(cross(bc, c + b), d);
    bool inside = min(wa, min(wb, wc)) >= 0.0 || max(wa, max(wb, wc)) <= 0.0;
    vec3 normal = cross(ab, bc);
    float cosine = dot(normal, d);
    float t = dot(normal, a) / cosine;
    if (!inside || cosine == 0.0 || !(t > 0.0 && t < tMax)) {
        return false;
    }
    tMax = t;
    uv = vec2(wb, wc) / (wa + wb + wc);
    return true;
}
#endif
