// Traces rays through the whole scene: unbounded shapes, the hierarchy over the objects, and the objects' shapes.
#ifndef HYALITE_SCENE_GLSL
#define HYALITE_SCENE_GLSL
#include "shapes/csg.glsl"

// Intersects an object that is not a mesh.
void traceShape(uint object, ObjectHeader header, Ray ray, inout Hit hit) {
    if (isShape(header.type, kShapeSphere)) {
        Start start = startAt(object, ray.from);
        if (intersectSphere(ray.origin, ray.direction, objectTexel(object, 0u), start, hit.t)) {
            hit = Hit(hit.t, object, 0u, vec2(0.0));
        }
    } else if (isShape(header.type, kShapeQuad) || isShape(header.type, kShapeDisk) ||
               isShape(header.type, kShapePlane)) {
        vec2 uv; // a ray that leaves a plane never hits it again
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

// Intersects every object; for scenes of few.
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

// Traverses the hierarchy over the objects and, in the same loop, those of the meshes in it: lanes inside a mesh do not
// wait for lanes still searching for one. Unbounded objects come before the hierarchy's root.
void traceObjects(uint root, Ray ray, bool any, inout Hit hit) {
    BoxRay box = boxRay(ray.origin, ray.direction);
    uint bottom = stackDepth;
    uint word = root;
    uint object = 0u; // the next one to intersect in the present leaf
    uint end = kEndlessObjects;
    if (kEndlessObjects > 0u) {
        pushEntries(1u, uvec3(root));
        word = kNone;
    }
    uint mesh = kNone; // the object whose mesh is being traversed; kNone: the traversal is among the objects
    uint bottomOfMesh = 0u;
    vec3 o = vec3(0.0), d = vec3(0.0); // the ray in the mesh's space; see traceMesh
    float skipped = kInfinity;         // kInfinity: not yet at the mesh's root
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

// Is every component of the ray finite? NaN compares false with everything, and traversal loops end by comparisons.
bool isFinite(Ray ray) {
    const float kLargest = 3.402823466e38;
    return all(lessThanEqual(abs(ray.origin), vec3(kLargest))) &&
           all(lessThanEqual(abs(ray.direction), vec3(kLargest))) && abs(ray.tMax) <= kLargest;
}

// The closest hit along the ray, or with `any` some hit; none for a ray with a non-finite component.
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
