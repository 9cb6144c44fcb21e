#version 460
#extension GL_GOOGLE_include_directive : require
// Stores a photon that lands on a diffuse surface after its first segment (direct light is sampled, not stored), then
// lets Russian roulette decide between reflection and absorption [Jensen01, ch. 5]. Nothing follows a photon that has
// used all but the last segment of the longest path: that one belongs to the camera.
#include "shared/kernel_arguments.h"
#include "lib/dielectric.glsl"
#include "lib/sampling.glsl"
#include "lib/surface.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { ScatterPhotonArguments args; };

void store(uint slot, Surface s, vec3 direction, vec3 power) {
    args.photons.at[slot] = Photon(s.position, packUnitVector(-direction, 16u), power,
                                   packUnitVector(s.normal, 12u) | (args.depth << 24u));
}

void follow(uint i, Surface s, vec3 direction, bool through, PhotonPath path, vec3 power) {
    args.nextRays.at[i] = leaveSurface(s, direction, through);
    args.nextPaths.at[i] = PhotonPath(power, path.photon);
    args.alive.at[i] = 1u;
}

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    args.alive.at[i] = 0u;
    args.photons.at[args.firstPhoton + i].surface = kNone;
    Hit hit = args.hits.at[i];
    if (hit.object == kNone) {
        return;
    }
    Ray ray = args.rays.at[i];
    PhotonPath path = args.paths.at[i];
    Surface s = surfaceAt(ray, hit, args.normals, args.instances);
    if (s.material == kNone) {
        return;
    }
    MaterialRecord material = args.materials.at[s.material];
    if (material.type == kMaterialDiffuse && args.depth >= 2u) {
        store(args.firstPhoton + i, s, ray.direction, path.power);
    }
    if (args.depth + 1u >= args.maxDepth) {
        return;
    }

    Sampler numbers = photonSampler(args.seed, args.pass, path.photon);
    uint vertex = args.depth - 1u;
    vec2 roulette = sampleUnit(numbers, photonScatter(vertex));
    if (material.type == kMaterialDielectric) {
        float cosIncident = clamp(-dot(ray.direction, s.normal), 0.0, 1.0); // a smoothed normal may be turned away
        Interface face = meetInterface(cosIncident, s.front ? 1.0 / material.ior : material.ior);
        bool reflects = roulette.y < face.reflectance;
        follow(i, s, reflects ? reflected(ray.direction, s.normal)
                              : refracted(ray.direction, s.normal, cosIncident, face), !reflects, path, path.power);
        return;
    }
    float survival = maxComponent(material.color);
    if (roulette.x >= survival) {
        return; // absorbed
    }
    vec3 power = path.power * material.color / survival;
    if (material.type == kMaterialMirror) {
        follow(i, s, reflected(ray.direction, s.normal), false, path, power);
    } else {
        follow(i, s, cosineHemisphere(sampleUnit(numbers, photonBounce(vertex)), s.normal), false, path, power);
    }
}
