// Rays through the whole scene: shapes without end, the hierarchy over the objects, and what each object is.
#ifndef HYALITE_SCENE_GLSL
#define HYALITE_SCENE_GLSL
#include "lib/csg.glsl"

void traceObject(uint object, Ray ray, bool any, inout Hit hit) {
    ObjectHeader header = objectHeader(object);
    if (isShape(header.type, kShapeSphere)) {
        Start start = startAt(object, ray.from);
        if (intersectSphere(ray.origin, ray.direction, objectTexel(object, 0u), start, hit.t)) {
            hit = Hit(hit.t, object, 0u, vec2(0.0));
        }
    } else if (isShape(header.type, kShapeQuad) || isShape(header.type, kShapeDisk) ||
               isShape(header.type, kShapePlane)) {
        vec2 uv; // a ray that leaves a plane never meets it again
        if (!startAt(object, ray.from).known &&
            intersectFlat(header.type, ray.origin, ray.direction, objectTexel(object, 0u), objectTexel(object, 1u),
                          objectTexel(object, 2u), hit.t, uv)) {
            hit = Hit(hit.t, object, 0u, uv);
        }
    } else if (isShape(header.type, kShapeMesh)) {
        vec3 o, d;
        toMeshSpace(object, ray, o, d);
        traceMesh(header.root, object, o, d, any, hit);
    } else if (isShape(header.type, kShapeCsg)) {
        traceCsg(object, header, ray, hit);
    } else if (sceneHas(kShapeQuadric) || sceneHas(kShapeTorus)) {
        intersectSolid(object, header.type, ray, hit);
    }
}

void traceRange(uint first, uint end, Ray ray, bool any, inout Hit hit) {
    for (uint object = first; object < end && !(any && hit.object != kNone); ++object) {
        traceObject(object, ray, any, hit);
    }
}

// Descends the hierarchy over the objects. Those without end stand before its root.
void traceObjects(uint root, Ray ray, bool any, inout Hit hit) {
    BoxRay box = boxRay(ray.origin, ray.direction);
    uint bottom = stackDepth;
    uint word = root;
    bool endless = kEndlessObjects > 0u;
    while (true) {
        if (!endless && (word & kLeafBit) == 0u) {
            uvec4 children;
            vec4 key = enterChildren(geometryRecord(word), box, hit.t, children);
            word = nextChild(key, children);
        } else {
            uint first = 0u;
            uint end = kEndlessObjects;
            if (!endless) {
                first = word & kLeafFirstMask;
                end = first + ((word & ~kLeafBit) >> kLeafCountShift);
                word = kNone;
            }
            endless = false;
            traceRange(first, end, ray, any, hit);
            if (any && hit.object != kNone) {
                stackDepth = bottom;
                return;
            }
        }
        if (word == kNone) {
            if (stackDepth == bottom) {
                return;
            }
            word = popEntry();
        }
    }
}

// The closest hit along the ray, or with `any` some hit.
Hit traceScene(uint root, Ray ray, bool any) {
    Hit hit = Hit(ray.tMax, kNone, 0u, vec2(0.0));
    if (kFewObjects > 0u) {
        traceRange(0u, kFewObjects, ray, any, hit);
    } else {
        traceObjects(root, ray, any, hit);
    }
    return hit;
}
#endif
