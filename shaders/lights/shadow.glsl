// What arrives along a shadow ray.
#ifndef HYALITE_SHADOW_GLSL
#define HYALITE_SHADOW_GLSL
#include "shared/path_records.h"
#include "bsdf/bsdf.glsl"
#include "bsdf/medium.glsl"
#include "shapes/scene.glsl"
#include "shapes/surface.glsl"
#include "shapes/touching.glsl"

// Dielectrics that one shadow ray passes at most; behind more it counts as occluded.
const uint kMostPassed = 64u;

// Share of the light that passes straight through a surface: through thin glass, and through the boundary of media of
// nearly equal index; 0: none.
float straightShare(MaterialRecord material, Surface s, vec3 direction) {
    if (!isMaterial(material.type, kMaterialDielectric)) {
        return 0.0;
    }
    if (isThin(material)) {
        return 1.0 - meetLobe(dielectricLobe(material, s.front), clamp(-dot(direction, s.normal), 0.0, 1.0)).reflectance;
    }
    return abs(material.ior - 1.0) < kSmoothIndex ? 1.0 : 0.0;
}

// The walk of a ray that passes; `media` around its start.
vec3 lightThroughGlass(uint root, Ray ray, uint media, MaterialArray materials, NormalArray normals,
                       InstanceArray instances) {
    vec3 share = vec3(1.0);
    vec3 end = ray.origin + ray.tMax * ray.direction;
    for (uint passed = 0u; passed < kMostPassed; ++passed) {
        Hit hit = traceScene(root, ray, false);
        share *= transmittance(materials, media, hit.t);
        if (hit.object == kNone) {
            return share;
        }
        Surface s = surfaceAt(ray, hit, normals, instances);
        if (mediaNeed(kMediaTouch)) {
            s = touching(s, media, materials, normals, instances);
        }
        if (s.material == kNone) {
            return vec3(0.0);
        }
        MaterialRecord material = materials.at[s.material];
        if (!mediaNeed(kMediaTouch)) {
            s.beyond = mediaBehind(material, s.material, s.front, media);
        }
        material = amongMedia(materials, material, s.front, media, s.beyond);
        share *= straightShare(material, s, ray.direction);
        if (maxComponent(share) == 0.0) {
            return vec3(0.0);
        }
        media = s.beyond;
        float tMax = ray.tMax;
        ray = leaveSurface(s, ray.direction, true);
        if (tMax < kInfinity) {
            ray.tMax = dot(end - ray.origin, ray.direction);
            if (ray.tMax <= 0.0) {
                return share;
            }
        }
    }
    return vec3(0.0);
}

// Share of the light that arrives along a shadow ray (see throughMedia); `media` around its start.
vec3 lightPassing(uint root, Ray shadow, uint media, MaterialArray materials, NormalArray normals,
                  InstanceArray instances) {
    bool passes = mediaNeed(kMediaShadows) && (shadow.from & kRayPasses) != 0u;
    shadow.from &= ~kRayPasses;
    if (passes) {
        return lightThroughGlass(root, shadow, media, materials, normals, instances);
    }
    return traceScene(root, shadow, true).object == kNone ? vec3(1.0) : vec3(0.0);
}
#endif
