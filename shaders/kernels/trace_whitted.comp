#version 460
#extension GL_GOOGLE_include_directive : require
// One level of the pixels' trees of rays [Whitted80], a ray a thread, from the ray to its light: the hit, what the surface
// emits, what comes to it straight from every lamp, and the rays that go on. At smooth glass both do, reflected and
// refracted, each with a sequence of random numbers of its own; where a surface has a diffuse part and a lobe, that is
// lit and this sends its ray.
//
// All in one kernel: with nothing to gather between the stages, what they hand on by memory costs more than it brings
// (docs/performance.md). An observer still sees it: `keptRays`.
// reads: slots of rays, rays and camera paths of the level before, tables, materials, textures, lights
// writes: light, pixels, rough points, next rays and paths, how many of a path's slots are used; for observers, hits,
//     emission, visible points
// threads: rays of a level
// computes: the four stages above for a level of the trees of rays: R and 1 − R at glass, L = Σ f I cosθ / d² over the
//     lights [Whitted80]
#include "shared/kernel_arguments.h"
#include "camera/camera_path.glsl"
#include "camera/camera_ray.glsl"
#include "lights/direct_light.glsl"
#include "bsdf/medium.glsl"
#include "shapes/scene.glsl"
#include "textures/texture.glsl"
#include "lib/counter.glsl"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { TraceWhittedArguments args; };

uint children = 0u; // next rays of this path, so far
Receiver receiver;  // at its visible point

void follow(uint i, Surface s, BsdfSample next, CameraPath path, uint samplerSeed) {
    path = pathAfter(s, next, path, samplerSeed);
    float weight = maxComponent(path.beta);
    if (args.depth < args.maxDepth && weight >= args.minWeight && weight > 0.0) {
        uint slot = 2u * i + children;
        args.nextRays.at[slot] = leaveSurface(s, next.direction, next.through);
        args.nextPaths.at[slot] = path;
        ++children;
    }
}

void splitAtGlass(uint i, Surface s, vec3 wo, Lobe lobe, CameraPath path) {
    float cosOut = clamp(dot(wo, s.normal), 0.0, 1.0);
    float reflectance = meetInterface(cosOut, lobe.eta).reflectance;
    BsdfSample next = sampleSmooth(lobe, s.normal, wo, 0.0, kRadiance);
    next.weight *= reflectance;
    follow(i, s, next, path, deriveSequence(path.samplerSeed, 1u));
    if (reflectance < 1.0) {
        next = sampleSmooth(lobe, s.normal, wo, 1.0, kRadiance);
        next.weight *= 1.0 - reflectance;
        follow(i, s, next, path, deriveSequence(path.samplerSeed, 2u));
    }
}

// A rough lobe gets its light from sample_rough_lights, at `result`.
void leaveByLobe(uint i, Surface s, vec3 wo, Lobe lobe, CameraPath path, uint result) {
    vec2 u = vec2(0.0);
    float choice = 0.0; // between the ways of rough glass
    if (sceneHasRoughLobes() && lobe.alpha > 0.0) {
        Sampler numbers = pathSampler(path.samplerSeed, args.pass);
        u = sampleUnit(numbers, cameraBounce(args.depth - 1u));
        choice = sampleUnit(numbers, cameraScatter(args.depth - 1u)).x;
        if (args.depth < args.maxDepth) {
            args.roughPoints.at[i] = roughAt(s, lobe, wo, path, args.depth, result);
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
        visible = visibleAt(s, wo, path, args.depth, 1.0);
        receiver = receiverOf(visible, material);
    }
    if (probability > 0.0) {
        if (isCoated(material)) { // of two lobes it follows one
            float ofLobe;
            Sampler numbers = pathSampler(path.samplerSeed, args.pass);
            lobe = pickLobe(lobe, cosOut, sampleUnit(numbers, cameraScatter(args.depth - 1u)).x, ofLobe);
            path.beta /= ofLobe;
        }
        leaveByLobe(i, s, wo, lobe, path, result);
    }
}

// From every lamp onto a diffuse surface.
vec3 lightOn(VisiblePoint x) {
    vec3 sum = vec3(0.0);
    uint rays = 0u;
    for (uint index = 0u; index < args.lightCount; ++index) {
        DirectLight toLight = directLight(args.lights.at[index], 1.0, x, receiver, false, lightSampler(x.samplerSeed, index, args.pass));
        if (isWorthAsking(toLight)) {
            ++rays;
            if (traceScene(args.rootNode, toLight.shadow, true).object == kNone) {
                sum += toLight.contribution;
            }
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
        path.beta *= transmittance(args.materials, path.medium, hit.t);
        emitted = emissionOf(s, args.lights, true, ray, hit.t, path);
        if (s.material != kNone) {
            MaterialRecord material = texturedMaterial(args.materials.at[s.material], s.position, s.uv);
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
