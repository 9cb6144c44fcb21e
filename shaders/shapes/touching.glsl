// Interfaces that coincide: where a dielectric touches other objects, rounding decides which of their surfaces a ray
// hits first, and in which order it would cross them. At such a hit all surfaces within a few errors of it, along its
// normal, are met at once.
#ifndef HYALITE_TOUCHING_GLSL
#define HYALITE_TOUCHING_GLSL
#include "bsdf/medium.glsl"
#include "shapes/scene.glsl"
#include "shapes/surface.glsl"

// Of the largest coordinate, of the place or of the smaller object: half the length of the segment on which surfaces are looked for, and the distance up to
// which they touch, besides their errors.
const float kWindow = 3.0517578125e-5; // 2^-15
const float kTouching = 3.814697265625e-6; // 2^-18

// Is the material's surface the boundary of a medium, or a sheet in one?
bool isTransparent(MaterialArray materials, uint material) {
    return material != kNone && isMaterial(materials.at[material].type, kMaterialDielectric);
}

void traceObject(uint object, Ray ray, inout Hit hit) {
    ObjectHeader header = objectHeader(object);
    if (isShape(header.type, kShapeMesh)) {
        vec3 o, d;
        toMeshSpace(object, ray, o, d);
        traceMesh(header.root, object, o, d, false, hit);
    } else {
        traceShape(object, header, ray, hit);
    }
}

// Does the object's surface pass through the place of `s`? Then `other` is the surface there, and `apart` its distance.
// `extent`: the largest coordinate of the smaller of the two objects.
bool touchesAt(uint object, float extent, Surface s, NormalArray normals, InstanceArray instances,
               out Surface other, out float apart) {
    float scale = max(largestCoordinate(s.position), extent);
    float reach = max(kWindow * scale, 16.0 * s.error);
    Ray window = Ray(s.position + reach * s.geometricNormal, 2.0 * reach, -s.geometricNormal, 0u);
    Hit hit = Hit(window.tMax, kNone, 0u, vec2(0.0));
    traceObject(object, window, hit);
    apart = 0.0;
    if (hit.object == kNone) {
        return false;
    }
    other = surfaceAt(window, hit, normals, instances);
    apart = abs(dot(other.position - s.position, s.geometricNormal));
    return apart <= 4.0 * (s.error + other.error) + kTouching * scale;
}

// The surface that a path in `media` meets at `s`: an opaque one, seen from these media, if any is there, else the
// boundary between them and those behind all surfaces that touch there. What is left is left before anything is
// entered; of media entered together, that of the larger object is the outer one. A ray from there starts clear of all.
Surface touching(Surface s, uint media, MaterialArray materials, NormalArray normals, InstanceArray instances) {
    InstanceRecord own = instances.at[s.object];
    uint beyond = media;
    uint entered = kNoMedia;
    float clear = s.error;
    bool isOpaque = !isTransparent(materials, s.material);
    Surface met = s;
    for (uint k = 0u; k < own.neighborCount; ++k) { // the larger objects first, and `s` among them
        uint object = own.neighbors.at[2u * k];
        float extent = uintBitsToFloat(own.neighbors.at[2u * k + 1u]);
        Surface other = s;
        float apart = 0.0;
        if (object != s.object && !touchesAt(object, extent, s, normals, instances, other, apart)) {
            continue;
        }
        clear = max(clear, apart + 2.0 * other.error);
        if (!isTransparent(materials, other.material)) {
            met = isOpaque ? met : other;
            isOpaque = true;
        } else if (!isThin(materials.at[other.material])) {
            if (other.front) {
                entered = enterMedium(entered, other.material, kMediumBits);
            } else {
                beyond = leaveMedium(beyond, other.material, kMediumBits);
            }
            if (!isOpaque && materials.at[other.material].roughness > materials.at[met.material].roughness) {
                met.material = other.material; // the roughest decides
            }
        }
    }
    if (own.neighborCount > 0u) {
        met.error = clear + 0.25 * kTouching * largestCoordinate(s.position);
    }
    if (isOpaque) {
        met.beyond = media;
        return met;
    }
    if (own.neighborCount == 0u) {
        met.beyond = mediaBehind(materials.at[s.material], s.material, s.front, media);
        return met;
    }
    for (uint place = mediaCapacity(kMediumBits); place > 0u; --place) {
        uint entry = mediumAt(entered, place - 1u, kMediumBits);
        beyond = entry == kNone ? beyond : enterMedium(beyond, entry, kMediumBits);
    }
    met.beyond = beyond;
    return met;
}
#endif
