#version 460
#extension GL_GOOGLE_include_directive : require
// What becomes of a photon where it lands: on a diffuse surface it is stored, then Russian roulette decides between
// reflection and absorption [Jensen01, ch. 5]. Nothing follows a photon that has used all but the last segment of the
// longest path: that one belongs to the camera.
#include "shared/kernel_arguments.h"
#include "lib/dielectric.glsl"
#include "lib/medium.glsl"
#include "lib/photon.glsl"
#include "lib/sampling.glsl"
#include "lib/surface.glsl"
#include "lib/texture.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { ScatterPhotonArguments args; };

bool isWanted(uint kind) {
    return ((args.kinds >> kind) & 1u) != 0u;
}

void store(uint slot, Surface s, vec3 direction, PhotonPath path) {
    bool marked = (path.photon + args.depth) % kMarkEvery == 0u;
    uint mark = marked ? kMarkedPhoton : 0u;
    args.photons.at[slot] = Photon(s.position, packUnitVector(-direction, kDirectionBits) | mark, path.power,
                                   packSurface(s.normal, path.kind,
                                               path.kind == kPhotonDirect ? path.light : args.depth));
}

void follow(uint i, Surface s, vec3 direction, bool through, PhotonPath path, vec3 power, uint kind) {
    args.nextRays.at[i] = leaveSurface(s, direction, through);
    path.power = power;
    path.kind = kind;
    path.medium = through ? (s.front ? s.material : kNone) : path.medium;
    args.nextPaths.at[i] = path;
    args.alive.at[i] = 1u;
}

// Leaves the surface if roulette and the longest path let it; `remaining`: flux that is reflected on average.
// Returns the flux that went on.
vec3 scatterDiffuse(uint i, Surface s, MaterialRecord material, PhotonPath path, Sampler numbers, float roulette) {
    float survival = maxComponent(material.color);
    if (roulette >= survival) {
        return vec3(0.0);
    }
    vec3 power = path.power * material.color / survival;
    vec2 u = sampleUnit(numbers, photonBounce(args.depth - 1u));
    follow(i, s, cosineHemisphere(u, s.normal), false, path, power, kPhotonIndirect);
    return power;
}

vec3 scatterSpecular(uint i, Surface s, MaterialRecord material, vec3 direction, PhotonPath path, vec2 roulette) {
    // Before its first diffuse surface, what a mirror or glass sends on may become a caustic
    uint kind = path.kind == kPhotonDirect ? kPhotonCaustic : path.kind;
    if (material.type == kMaterialDielectric) {
        float cosIncident = clamp(-dot(direction, s.normal), 0.0, 1.0); // a smoothed normal may be turned away
        Interface face = meetInterface(cosIncident, s.front ? 1.0 / material.ior : material.ior);
        bool reflects = roulette.y < face.reflectance;
        follow(i, s, reflects ? reflected(direction, s.normal) : refracted(direction, s.normal, cosIncident, face),
               !reflects, path, path.power, kind);
        return path.power;
    }
    float survival = maxComponent(material.color);
    if (roulette.x >= survival) {
        return vec3(0.0);
    }
    vec3 power = path.power * material.color / survival;
    follow(i, s, reflected(direction, s.normal), false, path, power, kind);
    return power;
}

void account(PhotonPath path, vec3 stored, vec3 absorbed, vec3 escaped, vec3 cutOff) {
    if (args.account != 0u) {
        PhotonFate fate = args.fates.at[path.photon];
        args.fates.at[path.photon] =
            PhotonFate(fate.stored + stored, fate.absorbed + absorbed, fate.escaped + escaped, fate.cutOff + cutOff);
    }
}

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    args.alive.at[i] = 0u;
    args.photons.at[args.firstPhoton + i].surface = kNone;
    Hit hit = args.hits.at[i];
    PhotonPath path = args.paths.at[i];
    if (hit.object == kNone) {
        account(path, vec3(0.0), vec3(0.0), path.power, vec3(0.0));
        return;
    }
    Ray ray = args.rays.at[i];
    Surface s = surfaceAt(ray, hit, args.normals, args.instances);
    vec3 started = path.power;
    path.power *= transmittance(args.materials, path.medium, hit.t);
    vec3 lost = started - path.power; // in glass, on the way here
    if (s.material == kNone) {
        account(path, vec3(0.0), started, vec3(0.0), vec3(0.0));
        return;
    }
    MaterialRecord material = texturedMaterial(args.materials.at[s.material], s);
    bool diffuse = material.type == kMaterialDiffuse;
    if (diffuse && isWanted(path.kind)) {
        store(args.firstPhoton + i, s, ray.direction, path);
    }

    vec3 onward = vec3(0.0);
    vec3 cutOff = vec3(0.0);
    if (args.depth + 1u >= args.maxDepth) {
        cutOff = path.power * material.color;
    } else if (!diffuse || isWanted(kPhotonIndirect)) {
        Sampler numbers = photonSampler(args.sequence, path.photon);
        vec2 roulette = sampleUnit(numbers, photonScatter(args.depth - 1u));
        onward = diffuse ? scatterDiffuse(i, s, material, path, numbers, roulette.x)
                         : scatterSpecular(i, s, material, ray.direction, path, roulette);
    }
    vec3 left = path.power - onward - cutOff;
    account(path, diffuse ? left : vec3(0.0), (diffuse ? vec3(0.0) : left) + lost, vec3(0.0), cutOff);
}
