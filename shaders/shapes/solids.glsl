// The crossings of a line with an analytic solid.
#ifndef HYALITE_SOLIDS_GLSL
#define HYALITE_SOLIDS_GLSL
#include "shared/path_records.h"
#include "shapes/quadric.glsl"
#include "shapes/shapes.glsl"
#include "lib/specialization.glsl"
#include "shapes/torus.glsl"

// |p - center|^2 - radius^2, exact to the roundings of p's coordinates where a large sphere passes near the origin.
float sphereForm(uint object, vec4 sphere, vec3 p) {
    return dot(p, p - 2.0 * sphere.xyz) + objectTexel(object, 1u).x;
}

bool isNearOrigin(vec4 sphere, vec3 p) {
    return dot(p, p) < 0.0625 * sphere.w * sphere.w;
}

// The roots of t^2 + 2 b t + c, in order; false if there are none.
bool orderedRoots(float b, float c, out vec2 t) {
    float discriminant = b * b - c;
    float root = sqrt(greater(discriminant, 0.0));
    float q = b > 0.0 ? -b - root : root - b;
    float t0 = q == 0.0 ? 0.0 : c / q;
    t = vec2(lesser(t0, q), greater(t0, q));
    return discriminant >= 0.0;
}

Crossings sphereCrossings(uint object, Ray ray) {
    Crossings crossings = noCrossings();
    vec4 sphere = objectTexel(object, 0u);
    vec2 t;
    bool meets;
    if (isNearOrigin(sphere, ray.origin)) {
        float b = dot(ray.origin, ray.direction) - dot(sphere.xyz, ray.direction);
        meets = orderedRoots(b, sphereForm(object, sphere, ray.origin), t);
    } else {
        meets = sphereRoots(ray.origin, ray.direction, sphere, false, t);
    }
    if (meets) {
        appendSpan(crossings, t, uvec2(0u));
    }
    return crossings;
}

Crossings solidCrossings(uint object, uint type, Ray ray) {
    if (isShape(type, kShapeTorus)) {
        return torusCrossings(object, ray.origin, ray.direction);
    }
    if (isShape(type, kShapeSphere)) {
        return sphereCrossings(object, ray);
    }
    return quadricCrossings(object, type, ray.origin, ray.direction);
}

// Crossings closer together than this are one place (see csg.glsl): 2^-18 of t or of the origin's largest coordinate, a
// few roundings; spaces and forms are chosen so that shapes larger than these coordinates round no more (quadric.cpp in
// host/kinds/shapes), except tori and meshes, whose size counts too (reach). A ray that knows on which side it starts ignores crossings within this distance of its start.
const float kPlaceLength = 3.814697265625e-6;

float startLength(vec3 origin) {
    return kPlaceLength * maxComponent(abs(origin));
}

// Index of the crossing that the ray meets first, 4: none. If the ray's side is known, it must cross to the other side,
// or crosses immediately if the two disagree within rounding.
int firstCrossing(Crossings crossings, Ray ray, Start start) {
    float around = startLength(ray.origin);
    float after = start.known ? around : 0.0;
    int index = 0;
    while (index < 4 && crossings.t[index] <= after) {
        ++index;
    }
    bool inside = (index & 1) != 0;
    if (start.known && inside != start.inside && index > 0 && crossings.t[index - 1] >= -around) {
        --index;
    }
    return index;
}

void intersectSolid(uint object, uint type, Ray ray, inout Hit hit) {
    Crossings crossings = solidCrossings(object, type, ray);
    if ((type & kShapeOpen) != 0u) {
        for (int i = 1; i >= 0; --i) {
            if (crossings.t[i] > 0.0 && crossings.t[i] < hit.t) {
                hit = Hit(crossings.t[i], object, crossings.part[i], vec2(0.0));
            }
        }
        return;
    }
    int index = firstCrossing(crossings, ray, startAt(object, ray.from));
    if (index < 4 && crossings.t[index] < hit.t) {
        hit = Hit(max(crossings.t[index], kTiny), object, crossings.part[index], vec2(0.0));
    }
}
#endif
