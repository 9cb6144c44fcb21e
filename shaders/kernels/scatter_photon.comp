#version 460
#extension GL_GOOGLE_include_directive : require
// Handles each photon where it lands: a diffuse surface stores it, then Russian roulette decides between reflection and
// absorption [Jensen01, ch. 5]. A photon may use all segments of the longest path but the last: that one belongs to the
// camera.
// reads: rays, hits, paths, materials, textures
// writes: photons, next rays and paths, alive flags
// threads: photon paths
// computes: store photon; Russian roulette, p = max albedo [Jensen01]
#include "shared/kernel_arguments.h"
#include "bsdf/bsdf.glsl"
#include "bsdf/medium.glsl"
#include "photons/photon.glsl"
#include "lib/sampling.glsl"
#include "shapes/surface.glsl"
#include "shapes/touching.glsl"
#include "textures/texture.glsl"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { ScatterPhotonArguments args; };

// Most that a photon's flux grows because of a smoothed normal: photons that graze the surface are few and would be
// too heavy.
const float kMostSmoothing = 32.0;

bool isWanted(uint kind) {
    return ((args.kinds >> kind) & 1u) != 0u;
}

// Photons land on a surface in proportion to the cosine at its geometric normal; light that is sampled directly counts
// by the cosine at the smoothed normal. Their ratio turns one into the other. 1 where the two normals are the same.
float arrivalFactor(Surface s, vec3 wo) {
    return min(max(0.0, dot(wo, s.normal)) / max(dot(wo, s.geometricNormal), kTiny), kMostSmoothing);
}

// The same for a lobe, with the inverse ratio for the direction that the photon leaves in: then photons carry what camera
// paths find in the opposite direction [Veach97, sec. 5.3].
float lobeFactor(Surface s, Lobe lobe, vec3 wo, vec3 wi) {
    float cosOut = dot(wo, s.normal);
    float cosIn = dot(wi, s.normal);
    bool isMirrored = lobe.alpha == 0.0 && cosOut * cosIn > 0.0; // the same angle, which rounding must not tell apart
    float smoothed = isMirrored ? 1.0 : abs(cosOut) / max(abs(cosIn), kTiny);
    return min(smoothed * abs(dot(wi, s.geometricNormal)) / max(abs(dot(wo, s.geometricNormal)), kTiny), kMostSmoothing);
}

bool isSmoothed(Surface s) {
    return s.normal != s.geometricNormal;
}

void store(uint slot, Surface s, vec3 direction, PhotonPath path) {
    bool marked = (path.photon + args.depth) % kMarkEvery == 0u;
    uint mark = marked ? kMarkedPhoton : 0u;
    args.photons.at[slot] = Photon(s.position, packUnitVector(-direction, kDirectionBits) | mark,
                                   isSmoothed(s) ? path.power * arrivalFactor(s, -direction) : path.power,
                                   packSurface(s.geometricNormal, path.kind,
                                               path.kind == kPhotonDirect ? path.light : args.depth));
}

void follow(uint i, Surface s, BsdfSample next, PhotonPath path, vec3 power, uint kind) {
    args.nextRays.at[i] = leaveSurface(s, next.direction, next.through);
    path.power = power;
    path.kind = kind;
    path.media = next.through ? s.beyond : path.media;
    args.nextPaths.at[i] = path;
    args.alive.at[i] = 1u;
}

// Scatters the photon by the lobe or the diffuse part if it survives roulette. Returns the flux that continues.
vec3 scatter(uint i, Surface s, MaterialRecord material, Lobe lobe, vec3 wo, PhotonPath path) {
    Sampler numbers = photonSampler(args.sequence, path.photon);
    vec2 roulette = sampleUnit(numbers, photonScatter(args.depth - 1u));
    vec2 u = sampleUnit(numbers, photonBounce(args.depth - 1u));
    float cosIn = clamp(dot(wo, s.normal), 0.0, 1.0);
    float probability = lobeProbability(material, lobe, cosIn);
    BsdfSample next;
    uint kind;
    if (roulette.y < probability) {
        float ofLobe;
        lobe = pickLobe(lobe, cosIn, roulette.y / probability, ofLobe);
        next = sampleLobe(lobe, s.normal, s.geometricNormal, wo, u, roulette.y, kFlux);
        next.weight /= probability;
        next.weight /= ofLobe;
        next.weight *= isSmoothed(s) ? lobeFactor(s, lobe, wo, next.direction) : 1.0;
        kind = path.kind == kPhotonDirect ? kPhotonCaustic : path.kind; // until it hits a diffuse surface
    } else {
        if (!isWanted(kPhotonIndirect)) {
            return vec3(0.0);
        }
        // Radiance leaves in all directions alike, and so flux by the cosine at the geometric normal
        next = sampleDiffuse(material, s.geometricNormal, cosIn, u, 1.0 - probability);
        if (isSmoothed(s)) {
            next.weight *= arrivalFactor(s, wo) * overDiffuse(material, clamp(dot(next.direction, s.normal), 0.0, 1.0)) /
                           overDiffuse(material, dot(next.direction, s.geometricNormal));
        }
        kind = kPhotonIndirect;
    }
    float survival = min(1.0, maxComponent(next.weight));
    if (roulette.x >= survival) {
        return vec3(0.0);
    }
    vec3 power = path.power * next.weight / survival;
    follow(i, s, next, path, power, kind);
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
    if (i >= liveCount(args.live, args.count)) {
        return;
    }
    args.alive.at[i] = 0u;
    uint slot = args.firstPhoton + i + (isSome(uvec2(args.live)) ? args.live.at[0].before : 0u);
    bool hasRoom = slot < args.room; // if there is none, the host notices from the queue's size
    if (hasRoom) {
        args.photons.at[slot].surface = kNone;
    }
    Hit hit = args.hits.at[i];
    PhotonPath path = args.paths.at[i];
    if (hit.object == kNone) {
        account(path, vec3(0.0), vec3(0.0), path.power, vec3(0.0));
        return;
    }
    Ray ray = args.rays.at[i];
    Surface s = surfaceAt(ray, hit, args.normals, args.instances);
    if (mediaNeed(kMediaTouch)) {
        s = touching(s, path.media, args.materials, args.normals, args.instances);
    }
    vec3 started = path.power;
    path.power *= transmittance(args.materials, path.media, hit.t);
    vec3 lost = started - path.power; // absorbed in glass on the way here
    if (s.material == kNone) {
        account(path, vec3(0.0), started, vec3(0.0), vec3(0.0));
        return;
    }
    MaterialRecord material = texturedMaterial(args.materials.at[s.material], s.position, s.uv);
    if (!mediaNeed(kMediaTouch)) {
        s.beyond = mediaBehind(material, s.material, s.front, path.media);
    }
    material = amongMedia(args.materials, material, s.front, path.media, s.beyond);
    bool diffuse = hasDiffusePart(material);
    Lobe lobe = lobeOf(material, s.front);
    if (diffuse && isWanted(path.kind) && hasRoom) {
        store(slot, s, ray.direction, path);
    }

    vec3 onward = vec3(0.0);
    vec3 cutOff = vec3(0.0);
    if (args.depth + 1u >= args.maxDepth) {
        float cosIn = clamp(-dot(ray.direction, s.normal), 0.0, 1.0);
        cutOff = path.power * leavingShare(material, lobe, cosIn);
    } else if (hasLobe(material) || isWanted(kPhotonIndirect)) {
        onward = scatter(i, s, material, lobe, -ray.direction, path);
    }
    vec3 left = path.power - onward - cutOff;
    account(path, diffuse ? left : vec3(0.0), (diffuse ? vec3(0.0) : left) + lost, vec3(0.0), cutOff);
}
