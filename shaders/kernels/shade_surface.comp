#version 460
#extension GL_GOOGLE_include_directive : require
// Decides what becomes of each camera path at its hit: emission is added, a diffuse surface ends the path as a visible
// point, a mirror or a dielectric sends it on. At a dielectric the path takes one of reflection and refraction
// (split = 0, visible points and emission stand at the pixel) or both (split = 1, they stand at the path's number).
#include "shared/kernel_arguments.h"
#include "lib/dielectric.glsl"
#include "lib/environment.glsl"
#include "lib/medium.glsl"
#include "lib/sampling.glsl"
#include "lib/surface.glsl"
#include "lib/texture.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { ShadeSurfaceArguments args; };

bool worthFollowing(vec3 beta) {
    return args.depth < args.maxDepth && maxComponent(beta) >= args.minWeight && maxComponent(beta) > 0.0;
}

void follow(uint slot, Surface s, vec3 direction, bool through, CameraPath path, vec3 beta, uint samplerSeed) {
    if (!worthFollowing(beta)) {
        return;
    }
    args.nextRays.at[slot] = leaveSurface(s, direction, through);
    path.beta = beta;
    path.medium = through ? (s.front ? s.material : kNone) : path.medium;
    path.samplerSeed = samplerSeed;
    args.nextPaths.at[slot] = path;
    args.alive.at[slot] = 1u;
}

void crossDielectric(uint slot, Surface s, vec3 d, CameraPath path, float ior) {
    float cosIncident = clamp(-dot(d, s.normal), 0.0, 1.0); // a smoothed normal may be turned away
    Interface i = meetInterface(cosIncident, s.front ? 1.0 / ior : ior);
    // Radiance over the squared index is what refraction conserves.
    vec3 transmittedBeta = path.beta * (i.eta * i.eta);
    vec3 reflection = reflected(d, s.normal);
    if (args.split != 0u) {
        follow(slot, s, reflection, false, path, path.beta * i.reflectance, hashCombine(path.samplerSeed, 1u));
        if (i.reflectance < 1.0) {
            follow(slot + 1u, s, refracted(d, s.normal, cosIncident, i), true, path,
                   transmittedBeta * (1.0 - i.reflectance), hashCombine(path.samplerSeed, 2u));
        }
        return;
    }
    float choice = sampleUnit(Sampler(path.samplerSeed, args.pass), cameraScatter(args.depth - 1u)).x;
    if (choice < i.reflectance) {
        follow(slot, s, reflection, false, path, path.beta, path.samplerSeed);
    } else {
        follow(slot, s, refracted(d, s.normal, cosIncident, i), true, path, transmittedBeta, path.samplerSeed);
    }
}

void main() {
    uint id = threadIndex();
    if (id >= args.count) {
        return;
    }
    uint slot = (1u + args.split) * id;
    args.alive.at[slot] = 0u;
    args.alive.at[slot + args.split] = 0u;
    Hit hit = args.hits.at[id];
    CameraPath path = args.paths.at[id];
    uint result = args.split != 0u ? id : path.pixel;
    VisiblePoint visible = VisiblePoint(vec3(0.0), 0u, vec3(0.0), path.samplerSeed, vec3(0.0), path.pixel, 0u, 0u);
    vec3 emitted = vec3(0.0);

    if (hit.object == kNone) {
        if (args.lights.at[0].type == kLightEnvironment) {
            emitted = path.beta * environmentRadiance(args.lights.at[0], args.rays.at[id].direction);
        }
    } else {
        Ray ray = args.rays.at[id];
        Surface s = surfaceAt(ray, hit, args.normals, args.instances);
        path.beta *= transmittance(args.materials, path.medium, hit.t);
        if (s.light != kNone && s.front) {
            emitted = path.beta * args.lights.at[s.light].emission;
        }
        if (s.material != kNone) {
            MaterialRecord material = texturedMaterial(args.materials.at[s.material], s);
            if (material.type == kMaterialDiffuse) {
                visible.position = s.position + s.error * s.geometricNormal;
                visible.depth = args.depth;
                visible.normal = s.normal;
                visible.geometricNormal = packUnitVector(s.geometricNormal, 16u);
                visible.f = path.beta * material.color * kInvPi;
                visible.from = leaving(s, false);
            } else if (material.type == kMaterialMirror) {
                follow(slot, s, reflected(ray.direction, s.normal), false, path, path.beta * material.color,
                       path.samplerSeed);
            } else if (material.type == kMaterialDielectric) {
                crossDielectric(slot, s, ray.direction, path, material.ior);
            }
        }
    }
    args.visiblePoints.at[result] = visible;
    // The first hit writes the pixel's emission, later ones add to it: at most one path per pixel is in flight.
    args.emitted.at[result] = args.split != 0u || args.depth == 1u ? emitted : args.emitted.at[result] + emitted;
}
