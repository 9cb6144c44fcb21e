// The crossings of a line with an analytic solid.
#ifndef HYALITE_SOLIDS_GLSL
#define HYALITE_SOLIDS_GLSL
#include "shared/path_records.h"
#include "shapes/quadric.glsl"
#include "shapes/shapes.glsl"
#include "lib/specialization.glsl"
#include "shapes/torus.glsl"

Crossings sphereCrossings(uint object, Ray ray) {
    Crossings crossings = noCrossings();
    vec2 t;
    if (sphereRoots(ray.origin, ray.direction, objectTexel(object, 0u), false, t)) {
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
// few roundings. A ray that knows on which side it starts ignores crossings within this distance of its start.
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
