#version 460
#extension GL_GOOGLE_include_directive : require
// Follows photons straight from the light through every surface. The first diffuse surface stores a direct photon,
// later ones store shadow photons without power: the former marks what the light reaches, the latter what is occluded
// [JensenChristensen95].
// reads: rays, hits, paths, materials
// writes: direct and shadow photons, next rays and paths, alive flags
// threads: photon paths
// computes: photons continue straight through every surface [JensenChristensen95]
#include "shared/kernel_arguments.h"
#include "bsdf/bsdf.glsl"
#include "photons/photon.glsl"
#include "shapes/surface.glsl"
#include "textures/texture.glsl"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { CastShadowPhotonsArguments args; };

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
    if (hit.object == kNone) {
        return;
    }
    Ray ray = args.rays.at[i];
    PhotonPath path = args.paths.at[i];
    Surface s = surfaceAt(ray, hit, args.normals, args.instances);
    if (hasRoom && s.material != kNone &&
        hasDiffusePart(texturedMaterial(args.materials.at[s.material], s.position, s.uv))) {
        args.photons.at[slot] =
            Photon(s.position, packUnitVector(-ray.direction, kDirectionBits), vec3(0.0),
                   packSurface(s.geometricNormal, path.kind, path.light));
    }
    path.kind = kPhotonShadow;
    args.nextRays.at[i] = leaveSurface(s, ray.direction, true);
    args.nextPaths.at[i] = path;
    args.alive.at[i] = 1u;
}
