// The crossings of a line with a solid that has a formula.
#ifndef HYALITE_SOLIDS_GLSL
#define HYALITE_SOLIDS_GLSL
#include "shared/path_records.h"
#include "lib/quadric.glsl"
#include "lib/shapes.glsl"
#include "lib/specialization.glsl"
#include "lib/torus.glsl"

Crossings sphereCrossings(uint object, Ray ray) {
    Crossings crossings = noCrossings();
    vec2 t;
    if (sphereRoots(ray.origin, ray.direction, objectTexel(object, 0u), t)) {
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
#endif
