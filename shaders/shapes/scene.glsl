// Rays through the whole scene: shapes without end, the hierarchy over the objects, and what each object is.
#ifndef HYALITE_SCENE_GLSL
#define HYALITE_SCENE_GLSL
#include "shapes/csg.glsl"

// An object that is no mesh.
void traceShape(uint object, ObjectHeader header, Ray ray, inout Hit hit) {
    if (isShape(header.type, kShapeSphere)) {
        Start start = startAt(object, ray.from);
        if (intersectSphere(ray.origin, ray.direction, objectTexel(object, 0u), start, hit.t)) {
            hit = Hit(hit.t, object, 0u, vec2(0.0));
        }
    } else if (isShape(header.type, kShapeQuad) || isShape(header.type, kShapeDisk) ||
               isShape(header.type, kShapePlane)) {
        vec2 uv; // a ray that leaves a plane never meets it again
        if (!startAt(object, ray.from).known &&
            intersectFlat(object, header.type, ray.origin, ray.direction, hit.t, uv)) {
            hit = Hit(hit.t, object, 0u, uv);
        }
    } else if (isShape(header.type, kShapeCsg)) {
        traceCsg(object, header, ray, hit);
    } else if (sceneHas(kShapeQuadric) || sceneHas(kShapeTorus)) {
        intersectSolid(object, header.type, ray, hit);
    }
}

// Tries each object of a scene of few.
void traceFew(Ray ray, bool any, inout Hit hit) {
    for (uint object = 0u; object < kFewObjects && !(any && hit.object != kNone); ++object) {
        ObjectHeader header = objectHeader(object);
        if (isShape(header.type, kShapeMesh)) {
            vec3 o, d;
            toMeshSpace(object, ray, o, d);
            traceMesh(header.root, object, o, d, any, hit);
        } else {
            traceShape(object, header, ray, hit);
        }
    }
}

// Descends the hierarchy over the objects and, in the same loop, those of the meshes among them: lanes of a subgroup that
// are in a mesh do not wait for those that look for one. Objects without end stand before the hierarchy's root.
void traceObjects(uint root, Ray ray, bool any, inout Hit hit) {
    BoxRay box = boxRay(ray.origin, ray.direction);
    uint bottom = stackDepth;
    uint word = root;
    uint object = 0u; // the next to be tried of the leaf that the ray is in
    uint end = kEndlessObjects;
    if (kEndlessObjects > 0u) {
        pushEntries(1u, uvec3(root));
        word = kNone;
    }
    uint mesh = kNone; // the object whose mesh the ray is in; kNone: it is among the objects
    uint bottomOfMesh = 0u;
    vec3 o = vec3(0.0), d = vec3(0.0); // the ray in the mesh's space; see traceMesh
    float skipped = kInfinity;         // kInfinity: it has not come to the mesh's root yet
    while (true) {
        bool isNode = (word & kLeafBit) == 0u;
        if (isNode || (mesh != kNone && word != kNone)) {
            GeometryRecord record = geometryRecord(word & kLeafFirstMask);
            if (isNode) {
                uvec4 children;
                vec4 key = enterChildren(record, box, hit.t, children);
                word = nextChild(key, children);
                if (mesh != kNone && skipped == kInfinity) {
                    skipped = key.x;
                    o += skipped * d;
                }
            } else {
                if (intersectTriangle(o, d, skipped, record, hit.t, hit.uv)) {
                    hit.object = mesh;
                    hit.primitive = word & kLeafFirstMask;
                }
                word = withoutFirst(word);
            }
        } else if (word != kNone) {
            object = word & kLeafFirstMask;
            end = object + ((word & ~kLeafBit) >> kLeafCountShift);
            word = kNone;
        }
        if (word == kNone) {
            if (mesh != kNone && stackDepth == bottomOfMesh) {
                mesh = kNone;
                box = boxRay(ray.origin, ray.direction);
            }
            if (mesh == kNone && object < end) {
                ObjectHeader header = objectHeader(object);
                if (isShape(header.type, kShapeMesh)) {
                    toMeshSpace(object, ray, o, d);
                    box = boxRay(o, d);
                    mesh = object;
                    bottomOfMesh = stackDepth;
                    skipped = kInfinity;
                    word = header.root;
                } else {
                    traceShape(object, header, ray, hit);
                }
                ++object;
            } else {
                if (stackDepth == bottom) {
                    return;
                }
                word = popEntry();
            }
        }
        if (any && hit.object != kNone) {
            stackDepth = bottom;
            return;
        }
    }
}

// Whether every number of the ray is finite. NaN compares false with everything, and walks end by comparisons.
bool isFinite(Ray ray) {
    const float kLargest = 3.402823466e38;
    return all(lessThanEqual(abs(ray.origin), vec3(kLargest))) &&
           all(lessThanEqual(abs(ray.direction), vec3(kLargest))) && abs(ray.tMax) <= kLargest;
}

// The closest hit along the ray, or with `any` some hit; none for a ray with a number that is not finite.
Hit traceScene(uint root, Ray ray, bool any) {
    Hit hit = Hit(ray.tMax, kNone, 0u, vec2(0.0));
    if (!isFinite(ray)) {
        return hit;
    }
    if (kFewObjects > 0u) {
        traceFew(ray, any, hit);
    } else {
        traceObjects(root, ray, any, hit);
    }
    return hit;
}
#endif
