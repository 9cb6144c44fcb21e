#version 460
#extension GL_GOOGLE_include_directive : require
// Shades each camera path at its hit: adds the emission to the path's pixel; a diffuse part ends the path as the
// pixel's visible point; a lobe continues the path. At smooth glass a random decision picks reflection or refraction;
// at a surface with a diffuse part and a lobe it picks one of the two.
// reads: rays, hits, paths, materials, textures, lights
// writes: visible and rough points, emission (the environment's if nothing was hit), next rays and paths, alive
//     flags
// threads: paths
// computes: reflection R = I − 2(N·I)N, Snell, Fresnel [Whitted80], microfacets [Walter07]; e^(−σt) in glass
#include "shared/kernel_arguments.h"
#include "camera/camera_path.glsl"
#include "bsdf/medium.glsl"
#include "shapes/touching.glsl"
#include "textures/texture.glsl"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { ShadeSurfaceArguments args; };

void follow(uint i, Surface s, BsdfSample next, CameraPath path) {
    path = pathAfter(s, next, path, path.samplerSeed);
    if (args.depth < args.maxDepth && maxComponent(path.beta) > 0.0) {
        args.nextRays.at[i] = leaveSurface(s, next.direction, next.through);
        args.nextPaths.at[i] = path;
        args.alive.at[i] = 1u;
    }
}

// The random number that picks one of the directions, or lobe or diffuse part.
float chosen(CameraPath path) {
    return sampleUnit(pathSampler(path.samplerSeed, args.pass), cameraScatter(args.depth - 1u)).x;
}

// Probability of following the reflection at smooth glass: the reflectance, except where only one of the two directions
// leads to a light; that one then gets at least kShareToLight. Otherwise a light that only 4 % of a pixel's paths reach
// dominates the noise behind glass. The internally reflected ray is followed through the next face, assuming a ball or,
// for any other shape, a parallel pane: in both, successive segments inside have equal length.
float reflectionProbability(Interface glass, Surface s, Hit hit, vec3 wo, float cosOut) {
    float F = glass.reflectance;
    if (kLightsSought == 0u || F <= 0.0 || F >= 1.0) {
        return F;
    }
    vec3 reflection = reflected(-wo, s.normal);
    if (s.front || glass.eta == 1.0) { // outside, or at thin glass
        return looksAtAny(args.lights, kLightsSought, s.position, reflection) ? max(F, kShareToLight) : F;
    }
    uint type = objectHeader(hit.object).type;
    bool isBall = isShape(type, kShapeSphere) && (type & kShapeLeaf) == 0u;
    vec3 nextNormal = isBall ? s.normal - 2.0 * cosOut * reflection : -s.normal;
    bool reflects = looksAtAny(args.lights, kLightsSought, s.position + hit.t * reflection,
                               refracted(reflection, nextNormal, cosOut, glass));
    bool refracts = looksAtAny(args.lights, kLightsSought, s.position, refracted(-wo, s.normal, cosOut, glass));
    if (reflects == refracts) {
        return F;
    }
    return reflects ? max(F, kShareToLight) : min(F, 1.0 - kShareToLight);
}

// Follows reflection or refraction at smooth glass; the weight is whatever the selection probability does not cancel.
void takeOneWay(uint i, Surface s, Hit hit, vec3 wo, Lobe lobe, CameraPath path) {
    float cosOut = clamp(dot(wo, s.normal), 0.0, 1.0);
    Interface glass = meetLobe(lobe, cosOut);
    float probability = reflectionProbability(glass, s, hit, wo, cosOut);
    bool reflects = chosen(path) < probability;
    BsdfSample next = sampleSmooth(lobe, s.normal, wo, reflects ? 0.0 : 1.0, kRadiance);
    if (probability != glass.reflectance) {
        next.weight *= reflects ? glass.reflectance / probability : (1.0 - glass.reflectance) / (1.0 - probability);
    }
    follow(i, s, next, path);
}

// Continues the path; at a rough lobe it also leaves a rough point, where lights are sampled. The lobe's probability is
// divided out of the throughput.
void leaveByLobe(uint i, Surface s, vec3 wo, Lobe lobe, CameraPath path, float choice) {
    vec2 u = vec2(0.0);
    if (sceneHasRoughLobes() && lobe.alpha > 0.0) {
        u = sampleUnit(pathSampler(path.samplerSeed, args.pass), cameraBounce(args.depth - 1u));
        if (args.depth < args.maxDepth) {
            args.roughPoints.at[i] = roughAt(s, lobe, wo, path, args.depth, path.pixel);
        }
    }
    follow(i, s, sampleLobe(lobe, s.normal, s.geometricNormal, wo, u, choice, kRadiance), path);
}

// If the material has both a diffuse part and a lobe, the path follows one of them.
void scatter(uint i, Surface s, Hit hit, MaterialRecord material, vec3 wo, CameraPath path, inout VisiblePoint visible) {
    Lobe lobe = lobeOf(material, s.front);
    if (isSmoothGlass(lobe)) {
        takeOneWay(i, s, hit, wo, lobe, path);
        return;
    }
    float cosOut = clamp(dot(wo, s.normal), 0.0, 1.0);
    float choice = chosen(path);
    float probability = lobeProbability(material, lobe, cosOut);
    if (choice >= probability) {
        visible = visibleAt(s, wo, path, args.depth, 1.0 - probability);
    } else {
        path.beta /= probability;
        float ofLobe;
        lobe = pickLobe(lobe, cosOut, choice / probability, ofLobe);
        path.beta /= ofLobe;
        leaveByLobe(i, s, wo, lobe, path, choice);
    }
}

void main() {
    uint count = liveCount(args.live, args.count);
    uint i = liveElement(args.width, count, args.count);
    if (i >= count) {
        return;
    }
    args.alive.at[i] = 0u;
    Hit hit = args.hits.at[i];
    CameraPath path = args.paths.at[i];
    if (sceneHasRoughLobes()) {
        args.roughPoints.at[i].depth = 0u;
    }
    VisiblePoint visible = noVisiblePoint(path);
    vec3 emitted = vec3(0.0);

    Ray ray = args.rays.at[i];
    if (hit.object == kNone) {
        emitted = emissionBeyond(args.lights, false, ray, path);
    } else {
        Surface s = surfaceAt(ray, hit, args.normals, args.instances);
        if (mediaNeed(kMediaTouch)) {
            s = touching(s, path.media, args.materials, args.normals, args.instances);
        }
        path.beta *= transmittance(args.materials, path.media, hit.t);
        emitted = emissionOf(s, args.lights, false, ray, hit.t, path);
        if (s.material != kNone) {
            MaterialRecord material = texturedMaterial(args.materials.at[s.material], s.position, s.uv);
            if (!mediaNeed(kMediaTouch)) {
                s.beyond = mediaBehind(material, s.material, s.front, path.media);
            }
            material = amongMedia(args.materials, material, s.front, path.media, s.beyond);
            scatter(i, s, hit, material, -ray.direction, path, visible);
        }
    }
    args.visiblePoints.at[path.pixel] = visible;
    // The first hit writes the pixel's emission, later ones add to it: at most one path per pixel is in flight.
    args.emitted.at[path.pixel] = args.depth == 1u ? emitted : args.emitted.at[path.pixel] + emitted;
}
