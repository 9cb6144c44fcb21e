// What a path needs to know of the point it hit.
#ifndef HYALITE_SURFACE_GLSL
#define HYALITE_SURFACE_GLSL
#include "shared/path_records.h"
#include "lib/math.glsl"
#include "lib/tables.glsl"

struct Surface {
    vec3 position;        // world [m]
    vec3 geometricNormal; // unit, on the side the ray came from
    vec3 normal;          // likewise, smoothed where a mesh has normals
    float error;          // bound on the error of position [m]
    bool front;           // the ray came from outside
    uint material;
    uint light;
};

// Positions of quads and spheres, and the next intersection's view of them, are a handful of roundings, each at most
// 2^-24 of the largest term; those of transformed triangles about twice as many. Twice that is safe, and small enough
// that where a ray lands does not move visibly.
const float kPositionError = 4.76837158203125e-7; // 2^-21
const float kTransformedPositionError = 1.9073486328125e-6; // 2^-19

// Off its plane a point of a quad is by the roundings of n.p alone, here and when the next ray meets the plane: three
// each time, one where p is moved onto the plane and one where the ray moves off it, each at most 2^-24 of the sum of
// |n_i p_i|; ten of them are assumed.
const float kPlaneError = 5.9604644775390625e-7; // 10 * 2^-24

float largestCoordinate(vec3 p) {
    return maxComponent(abs(p));
}

vec3 toWorld(InstanceRecord instance, vec4 p) {
    return vec3(dot(instance.row0, p), dot(instance.row1, p), dot(instance.row2, p));
}

Surface surfaceAt(Ray ray, Hit hit, NormalArray normals, InstanceArray instances) {
    ObjectHeader header = objectHeader(hit.object);
    Surface s;
    s.material = header.material;
    s.light = header.light;
    vec4 texel0 = objectTexel(hit.object, 0u);
    vec3 outward;
    if (header.type == kShapeSphere) {
        // Projected back onto the sphere, the point is right to the rounding of its coordinates however far the ray came
        vec3 p = ray.origin + hit.t * ray.direction;
        outward = normalize(p - texel0.xyz);
        s.position = texel0.xyz + texel0.w * outward;
        s.error = kPositionError * (largestCoordinate(texel0.xyz) + texel0.w);
        s.normal = outward;
    } else if (header.type == kShapeQuad) {
        // Projected back onto the plane
        vec3 p = ray.origin + hit.t * ray.direction;
        outward = texel0.xyz;
        s.position = p + (texel0.w - dot(outward, p)) * outward;
        s.error = kPlaneError * dot(abs(outward), abs(p));
        s.normal = outward;
    } else {
        vec3 a = triangleCorner(hit.primitive, 0u);
        vec3 b = triangleCorner(hit.primitive, 1u);
        vec3 c = triangleCorner(hit.primitive, 2u);
        vec3 weights = vec3(1.0 - hit.uv.x - hit.uv.y, hit.uv);
        vec3 p = weights.x * a + weights.y * b + weights.z * c;
        InstanceRecord instance = instances.at[hit.object];
        s.position = toWorld(instance, vec4(p, 1.0));
        vec3 terms = abs(instance.row0.xyz) * abs(p.x) + abs(instance.row1.xyz) * abs(p.y)
                   + abs(instance.row2.xyz) * abs(p.z)
                   + abs(vec3(instance.row0.w, instance.row1.w, instance.row2.w));
        s.error = kTransformedPositionError * largestCoordinate(max(terms, abs(s.position)));
        // Normals transform by the inverse transpose: the rows of world-to-object, which the object table holds
        mat3 rows = mat3(texel0.xyz, objectTexel(hit.object, 1u).xyz, objectTexel(hit.object, 2u).xyz);
        outward = normalize(rows * cross(b - a, c - a));
        vec3 smoothNormal = weights.x * normals.at[3u * hit.primitive] + weights.y * normals.at[3u * hit.primitive + 1u]
                          + weights.z * normals.at[3u * hit.primitive + 2u];
        s.normal = dot(smoothNormal, smoothNormal) > 0.0 ? normalize(rows * smoothNormal) : outward;
    }
    s.front = dot(ray.direction, outward) < 0.0;
    s.geometricNormal = s.front ? outward : -outward;
    s.normal = s.front ? s.normal : -s.normal;
    return s;
}

// A ray from the surface in `direction`, moved off it to the side it goes to by what the position may be wrong.
Ray leaveSurface(Surface s, vec3 direction) {
    float side = dot(direction, s.geometricNormal) < 0.0 ? -1.0 : 1.0;
    return Ray(s.position + (side * s.error) * s.geometricNormal, kInfinity, direction);
}
#endif
