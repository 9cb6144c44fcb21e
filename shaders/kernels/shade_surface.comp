#version 460
#extension GL_GOOGLE_include_directive : require
// Decides what becomes of each camera path at its hit: emission is added, a diffuse part ends the path as a visible
// point, a lobe sends it on. At smooth glass the path takes one of reflection and refraction, at a surface with both a
// diffuse part and a lobe one of these (split = 0, visible points and emission stand at the pixel), or both (split = 1,
// they stand at the path's number).
#include "shared/kernel_arguments.h"
#include "lib/bsdf.glsl"
#include "lib/light.glsl"
#include "lib/medium.glsl"
#include "lib/sampling.glsl"
#include "lib/surface.glsl"
#include "lib/texture.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { ShadeSurfaceArguments args; };

bool worthFollowing(vec3 beta) {
    return args.depth < args.maxDepth && maxComponent(beta) >= args.minWeight && maxComponent(beta) > 0.0;
}

void follow(uint slot, Surface s, BsdfSample next, CameraPath path, uint samplerSeed) {
    path.beta *= next.weight;
    if (!worthFollowing(path.beta)) {
        return;
    }
    path.samplerSeed = samplerSeed;
    path.medium = next.through ? (s.front ? s.material : kNone) : path.medium;
    path.pdfW = next.pdfW;
    args.nextRays.at[slot] = leaveSurface(s, next.direction, next.through);
    args.nextPaths.at[slot] = path;
    args.alive.at[slot] = 1u;
}

// Emission counts in full where no light was sampled for the path's direction. The normal is the light's where the ray
// meets it, `distance` away.
float emissionWeight(LightRecord light, Ray ray, float distance, vec3 normal, CameraPath path) {
    if (!(sceneHasRoughLobes() || kDiffuseBounces != 0u) || path.pdfW == 0.0) {
        return 1.0;
    }
    float pmf = args.split != 0u ? 1.0 : light.pmf;
    return powerHeuristic(path.pdfW, pmf * lightPdf(light, ray.origin, ray.direction, distance, normal));
}

VisiblePoint visibleAt(Surface s, DiffusePart diffuse, CameraPath path, float cosOut, float probability) {
    vec3 f = path.beta * diffuse.share * (diffuseFactor(diffuse.coat, cosOut) * kInvPi / probability);
    return VisiblePoint(s.position + s.error * s.geometricNormal, args.depth, s.normal, path.samplerSeed, f, path.pixel,
                        leaving(s, false), packUnitVector(s.geometricNormal, 16u), diffuse.coat);
}

// Both ways at smooth glass, each with a sequence of random numbers of its own.
void splitAtGlass(uint slot, Surface s, vec3 wo, Lobe lobe, CameraPath path) {
    float cosOut = clamp(dot(wo, s.normal), 0.0, 1.0);
    float reflectance = meetInterface(cosOut, lobe.eta).reflectance;
    BsdfSample next = sampleSmooth(lobe, s.normal, wo, 0.0, true);
    next.weight *= reflectance;
    follow(slot, s, next, path, deriveSequence(path.samplerSeed, 1u));
    if (reflectance < 1.0) {
        next = sampleSmooth(lobe, s.normal, wo, 1.0, true);
        next.weight *= 1.0 - reflectance;
        follow(slot + 1u, s, next, path, deriveSequence(path.samplerSeed, 2u));
    }
}

// The random number that chooses between the ways to go on.
float chosen(CameraPath path) {
    return sampleUnit(pathSampler(path.samplerSeed, args.pass), cameraScatter(args.depth - 1u)).x;
}

// With which probability a path takes the reflection at smooth glass: as much as is reflected; but where the one way leads
// to a light and the other does not, that one gets no less than kShareToLight. A lamp that only 4 % of a pixel's paths see
// is else what is noisy about glass. What is reflected inside is followed through the next face, taken for that of a ball
// or, of all other shapes, for that of a pane: in both each way inside is as long as the last.
float reflectionProbability(Interface glass, Surface s, Hit hit, vec3 wo, float cosOut) {
    float F = glass.reflectance;
    if (kLightsSought == 0u || F <= 0.0 || F >= 1.0) {
        return F;
    }
    vec3 reflection = reflected(-wo, s.normal);
    if (s.front) {
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

// One way at smooth glass, weighted by what its probability is not.
void takeOneWay(uint slot, Surface s, Hit hit, vec3 wo, Lobe lobe, CameraPath path) {
    float cosOut = clamp(dot(wo, s.normal), 0.0, 1.0);
    Interface glass = meetInterface(cosOut, lobe.eta);
    float probability = reflectionProbability(glass, s, hit, wo, cosOut);
    bool reflects = chosen(path) < probability;
    BsdfSample next = sampleSmooth(lobe, s.normal, wo, reflects ? 0.0 : 1.0, true);
    if (probability != glass.reflectance) {
        next.weight *= reflects ? glass.reflectance / probability : (1.0 - glass.reflectance) / (1.0 - probability);
    }
    follow(slot, s, next, path, path.samplerSeed);
}

// Sends the path on; at a rough lobe the lights are to be sampled too. Its throughput has the lobe's probability
// divided out.
void leaveByLobe(uint slot, Surface s, vec3 wo, Lobe lobe, CameraPath path, float choice) {
    Sampler numbers = pathSampler(path.samplerSeed, args.pass);
    vec2 u = vec2(0.0);
    if (sceneHasRoughLobes() && lobe.alpha > 0.0) {
        u = sampleUnit(numbers, cameraBounce(args.depth - 1u));
        if (args.depth < args.maxDepth) {
            uint id = slot / (1u + args.split);
            args.roughPoints.at[id] =
                RoughPoint(s.position, s.error, s.normal, args.depth, s.geometricNormal, path.samplerSeed, wo,
                           leaving(s, false), path.beta, args.split != 0u ? id : path.pixel, lobe);
        }
    }
    follow(slot, s, sampleLobe(lobe, s.normal, s.geometricNormal, wo, u, choice, true), path, path.samplerSeed);
}

// Where the material has a diffuse part and a lobe, the path takes one of them, or with `split` both.
void scatter(uint slot, Surface s, Hit hit, MaterialRecord material, vec3 wo, CameraPath path,
             inout VisiblePoint visible) {
    Lobe lobe = lobeOf(material, s.front);
    if (isMaterial(material.type, kMaterialDielectric) && lobe.alpha == 0.0) {
        if (args.split != 0u) {
            splitAtGlass(slot, s, wo, lobe, path);
        } else {
            takeOneWay(slot, s, hit, wo, lobe, path);
        }
        return;
    }
    DiffusePart diffuse = diffusePart(material);
    float cosOut = clamp(dot(wo, s.normal), 0.0, 1.0);
    float choice = chosen(path);
    float probability = lobeProbability(material, lobe, diffuse, cosOut);
    bool both = args.split != 0u && probability > 0.0 && probability < 1.0;
    if (both || choice >= probability) {
        visible = visibleAt(s, diffuse, path, cosOut, both ? 1.0 : 1.0 - probability);
    }
    if (both || choice < probability) {
        path.beta /= both ? 1.0 : probability;
        leaveByLobe(slot, s, wo, lobe, path, choice);
    }
}

void main() {
    uint id = threadPixel(args.width, args.count);
    if (id >= args.count) {
        return;
    }
    uint slot = (1u + args.split) * id;
    args.alive.at[slot] = 0u;
    args.alive.at[slot + args.split] = 0u;
    Hit hit = args.hits.at[id];
    CameraPath path = args.paths.at[id];
    uint result = args.split != 0u ? id : path.pixel;
    if (sceneHasRoughLobes()) {
        args.roughPoints.at[id].depth = 0u;
    }
    VisiblePoint visible = VisiblePoint(vec3(0.0), 0u, vec3(0.0), path.samplerSeed, vec3(0.0), path.pixel, 0u, 0u, 0.0);
    vec3 emitted = vec3(0.0);

    Ray ray = args.rays.at[id];
    if (hit.object == kNone) {
        LightRecord light = args.lights.at[0];
        if (isLight(light.type, kLightEnvironment)) {
            emitted = path.beta * environmentRadiance(light, ray.direction) *
                      emissionWeight(light, ray, kInfinity, vec3(0.0), path);
        }
    } else {
        Surface s = surfaceAt(ray, hit, args.normals, args.instances);
        path.beta *= transmittance(args.materials, path.medium, hit.t);
        if (s.light != kNone && s.front) {
            LightRecord light = args.lights.at[s.light];
            emitted = path.beta * light.emission * emissionWeight(light, ray, hit.t, s.geometricNormal, path);
        }
        if (s.material != kNone) {
            MaterialRecord material = texturedMaterial(args.materials.at[s.material], s);
            scatter(slot, s, hit, material, -ray.direction, path, visible);
        }
    }
    args.visiblePoints.at[result] = visible;
    // The first hit writes the pixel's emission, later ones add to it: at most one path per pixel is in flight.
    args.emitted.at[result] = args.split != 0u || args.depth == 1u ? emitted : args.emitted.at[result] + emitted;
}
