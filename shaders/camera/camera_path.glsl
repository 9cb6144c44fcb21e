// Camera paths at surfaces, shared by the integrators that follow one direction and Whitted's, which follows all: the
// light that a path sees, and the records that it leaves or passes on.
#ifndef HYALITE_CAMERA_PATH_GLSL
#define HYALITE_CAMERA_PATH_GLSL
#include "shared/path_records.h"
#include "bsdf/bsdf.glsl"
#include "lights/light.glsl"
#include "lib/sampling.glsl"
#include "shapes/surface.glsl"

// ---- What a path sees of lights

// Emission counts in full if no light was sampled for the path's direction; otherwise multiple importance sampling
// weights the two [Veach95]. `every`: every light is sampled, none picked. `normal`: the light's, where the ray hits it,
// `distance` away.
float emissionWeight(LightArray lights, uint index, bool every, Ray ray, float distance, vec3 normal, CameraPath path) {
    if (!(sceneHasRoughLobes() || kDiffuseBounces != 0u) || path.pdfW == 0.0) {
        return 1.0;
    }
    float pmf = every ? 1.0 : pickProbability(lights, index, ray.origin);
    return powerHeuristic(path.pdfW, pmf * lightPdf(lights.at[index], ray.origin, ray.direction, distance, normal));
}

// Emission of a ray that leaves the scene: the environment is the first light.
vec3 emissionBeyond(LightArray lights, bool every, Ray ray, CameraPath path) {
    LightRecord light = lights.at[0];
    if (!isLight(light.type, kLightEnvironment)) {
        return vec3(0.0);
    }
    return path.beta * environmentRadiance(light, ray.direction) *
           emissionWeight(lights, 0u, every, ray, kInfinity, vec3(0.0), path);
}

// Emission of the surface that the ray hits `distance` away.
vec3 emissionOf(Surface s, LightArray lights, bool every, Ray ray, float distance, CameraPath path) {
    if (s.light == kNone || !s.front) {
        return vec3(0.0);
    }
    LightRecord light = lights.at[s.light];
    return path.beta * light.emission *
           emissionWeight(lights, s.light, every, ray, distance, s.geometricNormal, path);
}

// ---- What it leaves, and what goes on

// `probability`: that the path takes the diffuse part.
VisiblePoint visibleAt(Surface s, vec3 wo, CameraPath path, uint depth, float probability) {
    return VisiblePoint(s.position + s.error * s.geometricNormal, depth, s.normal, path.samplerSeed, s.position,
                        leaving(s, false), wo, packUnitVector(s.geometricNormal, 16u), path.beta, path.pixel, s.uv,
                        s.material, probability, path.media);
}

VisiblePoint noVisiblePoint(CameraPath path) {
    return VisiblePoint(vec3(0.0), 0u, vec3(0.0), path.samplerSeed, vec3(0.0), 0u, vec3(0.0), 0u, vec3(0.0), path.pixel,
                        vec2(0.0), kNone, 1.0, kNoMedia);
}

// `result`: index where the point's light is added.
RoughPoint roughAt(Surface s, Lobe lobe, vec3 wo, CameraPath path, uint depth, uint result) {
    return RoughPoint(s.position, s.error, s.normal, depth, s.geometricNormal, path.samplerSeed, wo, leaving(s, false),
                      path.beta, result, s.uv, s.material, lobe.isCoat ? 1u : 0u, path.media, s.beyond);
}

// The path after the surface, with its own random sequence if the surface emits two paths.
CameraPath pathAfter(Surface s, BsdfSample next, CameraPath path, uint samplerSeed) {
    path.beta *= next.weight;
    path.samplerSeed = samplerSeed;
    path.media = next.through ? s.beyond : path.media;
    path.pdfW = next.pdfW;
    return path;
}
#endif
