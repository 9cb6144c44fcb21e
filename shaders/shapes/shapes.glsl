// Intersects a ray with a sphere or a flat shape. `d` is unit.
#ifndef HYALITE_SHAPES_GLSL
#define HYALITE_SHAPES_GLSL
#include "shared/path_records.h"
#include "lib/math.glsl"
#include "lib/specialization.glsl"
#include "lib/tables.glsl"

// A ray's knowledge of an object that it may be leaving.
struct Start {
    bool known;  // it leaves this object
    bool inside; // and runs inside it
};

Start startAt(uint object, uint from) {
    return Start((from & ~kRayInside) == 1u + object, (from & kRayInside) != 0u);
}

// Both roots, in order; from inside there are always two. The discriminant comes from the distance between centre and
// line, and the nearer root from the product of both, so neither loses precision far away or on the surface [Haines19].
bool sphereRoots(vec3 o, vec3 d, vec4 sphere, bool isInside, out vec2 t) {
    vec3 fromCenter = o - sphere.xyz;
    float radius = sphere.w;
    float b = dot(fromCenter, d);
    vec3 offLine = fromCenter - b * d;
    float discriminant = radius * radius - dot(offLine, offLine);
    if (discriminant < 0.0 && !isInside) {
        return false;
    }
    float distance = length(fromCenter);
    float c = (distance - radius) * (distance + radius);
    float root = sqrt(greater(discriminant, 0.0));
    float q = b > 0.0 ? -b - root : root - b;
    float t0 = q == 0.0 ? 0.0 : c / q;
    t = vec2(lesser(t0, q), greater(t0, q));
    return true;
}

// The nearest t in (0, tMax); lowers tMax to it. A ray that leaves the sphere hits it again at the farther root or
// never.
bool intersectSphere(vec3 o, vec3 d, vec4 sphere, Start start, inout float tMax) {
    vec2 roots;
    if ((start.known && !start.inside) || !sphereRoots(o, d, sphere, start.known, roots)) {
        return false;
    }
    float t = start.known ? max(roots.y, kTiny) : roots.x > 0.0 ? roots.x : roots.y;
    if (!(t > 0.0 && t < tMax)) {
        return false;
    }
    tMax = t;
    return true;
}

// A flat shape is a plane and, unless it is unbounded, two affine coordinates in it (see scene_records.h), which are
// loaded only if the ray hits the plane.
bool intersectFlat(uint object, uint type, vec3 o, vec3 d, inout float tMax, out vec2 uv) {
    vec4 plane = objectTexel(object, 0u);
    float t = (plane.w - dot(plane.xyz, o)) / dot(plane.xyz, d);
    bool meets = t > 0.0 && t < tMax;
    uv = vec2(0.0);
    if (meets && !isShape(type, kShapePlane)) {
        vec4 uRow = objectTexel(object, 1u);
        vec4 vRow = objectTexel(object, 2u);
        vec3 p = o + t * d;
        uv = vec2(dot(uRow.xyz, p) + uRow.w, dot(vRow.xyz, p) + vRow.w);
        meets = isShape(type, kShapeQuad) ? all(greaterThanEqual(uv, vec2(0.0))) && all(lessThanEqual(uv, vec2(1.0)))
                                          : dot(uv, uv) <= 1.0;
    }
    tMax = meets ? t : tMax;
    return meets;
}
#endif
