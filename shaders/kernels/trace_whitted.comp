#version 460
#extension GL_GOOGLE_include_directive : require
// Traces one level of the pixels' ray trees [Whitted80], one thread per ray: the hit, the surface's emission, direct
// light from every light, and the next rays. Smooth glass emits both a reflected and a refracted ray, each with its own
// random sequence; a surface with a diffuse part and a lobe is lit on the former and continues by the latter.
//
// All in one kernel: without photons to gather between the stages, passing data through memory costs more than it gains
// (docs/performance.md). An observer still sees it: `keptRays`.
// reads: slots of rays, rays and camera paths of the previous level, tables, materials, textures, lights
// writes: light, pixels, rough points, next rays and paths, number of used slots per path; for observers: hits,
//     emission, visible points
// threads: rays of one level
// computes: the four stages above for one level of the ray trees: R and 1 − R at glass, L = Σ f I cosθ / d² over the
//     lights [Whitted80]
#include "shared/kernel_arguments.h"
#include "camera/camera_path.glsl"
#include "camera/camera_ray.glsl"
#include "lights/direct_light.glsl"
#include "bsdf/medium.glsl"
#include "lights/shadow.glsl"
#include "shapes/touching.glsl"
#include "textures/texture.glsl"
#include "lib/counter.glsl"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { TraceWhittedArguments args; };

// Segments from the camera to the hits of this level.
uint depth() {
    return args.depths % kDepthsUnit;
}

uint children = 0u; // next rays of this path so far
Receiver receiver;  // at its visible point

void follow(uint i, Surface s, BsdfSample next, CameraPath path, uint samplerSeed) {
    path = pathAfter(s, next, path, samplerSeed);
    float weight = maxComponent(path.beta);
    if (depth() < args.depths / kDepthsUnit && weight >= args.minWeight && weight > 0.0) {
        uint slot = 2u * i + children;
        args.nextRays.at[slot] = leaveSurface(s, next.direction, next.through);
        args.nextPaths.at[slot] = path;
        ++children;
    }
}

void splitAtGlass(uint i, Surface s, vec3 wo, Lobe lobe, CameraPath path) {
    float cosOut = clamp(dot(wo, s.normal), 0.0, 1.0);
    float reflectance = meetLobe(lobe, cosOut).reflectance;
    BsdfSample next = sampleSmooth(lobe, s.normal, wo, 0.0, kRadiance);
    next.weight *= reflectance;
    follow(i, s, next, path, deriveSequence(path.samplerSeed, 1u));
    if (reflectance < 1.0) {
        next = sampleSmooth(lobe, s.normal, wo, 1.0, kRadiance);
        next.weight *= 1.0 - reflectance;
        follow(i, s, next, path, deriveSequence(path.samplerSeed, 2u));
    }
}

// sample_rough_lights adds the light of a rough lobe at `result`.
void leaveByLobe(uint i, Surface s, vec3 wo, Lobe lobe, CameraPath path, uint result) {
    vec2 u = vec2(0.0);
    float choice = 0.0; // between reflection and refraction at rough glass
    if (sceneHasRoughLobes() && lobe.alpha > 0.0) {
        Sampler numbers = pathSampler(path.samplerSeed, args.pass);
        u = sampleUnit(numbers, cameraBounce(depth() - 1u));
        choice = sampleUnit(numbers, cameraScatter(depth() - 1u)).x;
        if (depth() < args.depths / kDepthsUnit) {
            args.roughPoints.at[i] = roughAt(s, lobe, wo, path, depth(), result);
        }
    }
    follow(i, s, sampleLobe(lobe, s.normal, s.geometricNormal, wo, u, choice, kRadiance), path, path.samplerSeed);
}

void scatter(uint i, Surface s, MaterialRecord material, vec3 wo, CameraPath path, uint result,
             inout VisiblePoint visible) {
    Lobe lobe = lobeOf(material, s.front);
    if (isSmoothGlass(lobe)) {
        splitAtGlass(i, s, wo, lobe, path);
        return;
    }
    float cosOut = clamp(dot(wo, s.normal), 0.0, 1.0);
    float probability = lobeProbability(material, lobe, cosOut);
    if (probability < 1.0) {
        visible = visibleAt(s, wo, path, depth(), 1.0);
        receiver = receiverOf(visible, material);
    }
    if (probability > 0.0) {
        if (isCoated(material)) { // it follows one of two lobes
            float ofLobe;
            Sampler numbers = pathSampler(path.samplerSeed, args.pass);
            lobe = pickLobe(lobe, cosOut, sampleUnit(numbers, cameraScatter(depth() - 1u)).x, ofLobe);
            path.beta /= ofLobe;
        }
        leaveByLobe(i, s, wo, lobe, path, result);
    }
}

// Direct light from every light onto a diffuse surface.
vec3 lightOn(VisiblePoint x) {
    vec3 sum = vec3(0.0);
    uint rays = 0u;
    for (uint index = 0u; index < args.lightCount; ++index) {
        DirectLight toLight = directLight(args.lights.at[index], 1.0, x, receiver, false, lightSampler(x.samplerSeed, index, args.pass));
        toLight = throughMedia(toLight, args.materials, x.media, true);
        if (isWorthAsking(toLight)) {
            ++rays;
            sum += toLight.contribution * lightPassing(args.rootNode, toLight.shadow, x.media, args.materials,
                                                       args.normals, args.instances);
        }
    }
    countAll(args.rayCount, rays);
    return sum;
}

void main() {
    uint i = threadIndex();
    if (i >= liveCount(args.live, args.count)) {
        return;
    }
    NextRay arriving;
    uint result = i;
    if (!isSome(uvec2(args.slots))) {
        result = threadPixel(args.camera.width, args.count);
        arriving = startAtCamera(args.camera, args.seed, args.pass, result);
    } else {
        uint slot = args.slots.at[i];
        arriving = NextRay(args.rays.at[slot], args.paths.at[slot]);
        args.pixels.at[i] = arriving.path.pixel;
    }
    Ray ray = arriving.ray;
    CameraPath path = arriving.path;
    if (sceneHasRoughLobes()) {
        args.roughPoints.at[i].depth = 0u;
    }
    VisiblePoint visible = noVisiblePoint(path);
    vec3 emitted = vec3(0.0);

    Hit hit = traceScene(args.rootNode, ray, false);
    if (hit.object == kNone) {
        emitted = emissionBeyond(args.lights, true, ray, path);
    } else {
        Surface s = surfaceAt(ray, hit, args.normals, args.instances);
        if (mediaNeed(kMediaTouch)) {
            s = touching(s, path.media, args.materials, args.normals, args.instances);
        }
        path.beta *= transmittance(args.materials, path.media, hit.t);
        emitted = emissionOf(s, args.lights, true, ray, hit.t, path);
        if (s.material != kNone) {
            MaterialRecord material = texturedMaterial(args.materials.at[s.material], s.position, s.uv);
            if (!mediaNeed(kMediaTouch)) {
                s.beyond = mediaBehind(material, s.material, s.front, path.media);
            }
            material = amongMedia(args.materials, material, s.front, path.media, s.beyond);
            scatter(i, s, material, -ray.direction, path, result, visible);
        }
    }
    args.alive.at[i] = children;
    if (isSome(uvec2(args.keptRays))) {
        args.keptRays.at[i] = arriving.ray;
        args.keptPaths.at[i] = arriving.path;
        args.hits.at[i] = hit;
        args.emitted.at[i] = emitted;
        args.visiblePoints.at[i] = visible;
    }
    if (visible.depth != 0u) {
        emitted += lightOn(visible);
    }
    args.light.at[result] = emitted;
}
