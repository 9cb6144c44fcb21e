// What becomes of camera paths at surfaces, alike for the integrators that take one way on and for Whitted's, which takes
// all of them: what they see of lights, and what they leave behind or carry on.
#ifndef HYALITE_CAMERA_PATH_GLSL
#define HYALITE_CAMERA_PATH_GLSL
#include "shared/path_records.h"
#include "bsdf/bsdf.glsl"
#include "lights/light.glsl"
#include "lib/sampling.glsl"
#include "shapes/surface.glsl"

// ---- What a path sees of lights

// Emission counts in full where no light was sampled for the path's direction; else the two are weighed against one
// another [Veach95]. `pmf`: with which probability the light would have been picked. `normal`: the light's where the ray
// meets it, `distance` away.
float emissionWeight(LightRecord light, float pmf, Ray ray, float distance, vec3 normal, CameraPath path) {
    if (!(sceneHasRoughLobes() || kDiffuseBounces != 0u) || path.pdfW == 0.0) {
        return 1.0;
    }
    return powerHeuristic(path.pdfW, pmf * lightPdf(light, ray.origin, ray.direction, distance, normal));
}

// From beyond the scene: the environment is the first of the lights. `every`: every light is sampled, none picked.
vec3 emissionBeyond(LightArray lights, bool every, Ray ray, CameraPath path) {
    LightRecord light = lights.at[0];
    if (!isLight(light.type, kLightEnvironment)) {
        return vec3(0.0);
    }
    return path.beta * environmentRadiance(light, ray.direction) *
           emissionWeight(light, every ? 1.0 : light.pmf, ray, kInfinity, vec3(0.0), path);
}

// From the surface that the ray meets `distance` away.
vec3 emissionOf(Surface s, LightArray lights, bool every, Ray ray, float distance, CameraPath path) {
    if (s.light == kNone || !s.front) {
        return vec3(0.0);
    }
    LightRecord light = lights.at[s.light];
    return path.beta * light.emission *
           emissionWeight(light, every ? 1.0 : light.pmf, ray, distance, s.geometricNormal, path);
}

// ---- What it leaves, and what goes on

// `probability`: of the diffuse part among the directions that the path might have taken.
VisiblePoint visibleAt(Surface s, vec3 wo, CameraPath path, uint depth, float probability) {
    return VisiblePoint(s.position + s.error * s.geometricNormal, depth, s.normal, path.samplerSeed, s.position,
                        leaving(s, false), wo, packUnitVector(s.geometricNormal, 16u), path.beta, path.pixel, s.uv,
                        s.material, probability);
}

VisiblePoint noVisiblePoint(CameraPath path) {
    return VisiblePoint(vec3(0.0), 0u, vec3(0.0), path.samplerSeed, vec3(0.0), 0u, vec3(0.0), 0u, vec3(0.0), path.pixel,
                        vec2(0.0), kNone, 1.0);
}

// `result`: where the light is to be added that it gets.
RoughPoint roughAt(Surface s, Lobe lobe, vec3 wo, CameraPath path, uint depth, uint result) {
    return RoughPoint(s.position, s.error, s.normal, depth, s.geometricNormal, path.samplerSeed, wo, leaving(s, false),
                      path.beta, result, s.uv, s.material, lobe.isCoat ? 1u : 0u);
}

// The path behind the surface, with random numbers of its own if it is one of two.
CameraPath pathAfter(Surface s, BsdfSample next, CameraPath path, uint samplerSeed) {
    path.beta *= next.weight;
    path.samplerSeed = samplerSeed;
    path.medium = next.through ? (s.front ? s.material : kNone) : path.medium;
    path.pdfW = next.pdfW;
    return path;
}
#endif
