#version 460
#extension GL_GOOGLE_include_directive : require
// Samples a point on a light for each rough point and adds its light if it is unoccluded.
// reads: rough points, lights, tables
// writes: direct light, marks of the pixels where light was sought
// threads: camera paths
// computes: L = f E cosθ / pmf as above, times p² / (p² + q²) if BSDF sampling can also hit the light [Veach95], [Walter07]
#include "shared/kernel_arguments.h"
#include "lights/direct_light.glsl"
#include "lights/shadow.glsl"
#include "lib/counter.glsl"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { SampleRoughLightsArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= liveCount(args.live, args.count)) {
        return;
    }
    RoughPoint x = args.roughPoints.at[i];
    if (x.depth == 0u) {
        return;
    }
    MaterialRecord material = texturedMaterial(args.materials.at[x.material], x.position, x.uv);
    bool front = (x.from & kRayInside) == 0u;
    material = amongMedia(args.materials, material, front, x.media, x.beyond);
    Lobe lobe = x.isCoat != 0u ? coatOf(material) : lobeOf(material, front);
    Sampler s = lightSampler(x.samplerSeed, args.light, args.pass);
    LightPick pick = lightAsked(args.lights, args.light, x.position, s, x.depth);
    DirectLight toLight = directLight(args.lights.at[pick.light], pick.pmf, x, lobe, s);
    if (isSome(uvec2(args.sought))) {
        args.sought.at[x.result] = 1u;
    }
    bool isThrough = dot(toLight.shadow.direction, x.geometricNormal) < 0.0;
    uint media = isThrough ? x.beyond : x.media;
    toLight = throughMedia(toLight, args.materials, media, toLight.discrete);
    bool asks = isWorthAsking(toLight);
    countAll(args.rayCount, asks ? 1u : 0u);
    if (asks) {
        vec3 share = lightPassing(args.rootNode, toLight.shadow, media, args.materials, args.normals, args.instances);
        if (maxComponent(share) > 0.0) {
            args.direct.at[x.result] += toLight.contribution * share;
        }
    }
}
