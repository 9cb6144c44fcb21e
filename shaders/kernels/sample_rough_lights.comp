#version 460
#extension GL_GOOGLE_include_directive : require
// Picks a point on a light for each rough point and adds its light if nothing stands between.
// reads: rough points, lights, tables
// writes: direct light
// threads: camera paths
// computes: L = f E cosθ / pmf as above, times p² / (p² + q²) where rays can find the light too [Veach95], [Walter07]
#include "shared/kernel_arguments.h"
#include "lights/direct_light.glsl"
#include "shapes/scene.glsl"
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
    Lobe lobe = x.isCoat != 0u ? coatOf(material) : lobeOf(material, (x.from & kRayInside) == 0u);
    Sampler s = lightSampler(x.samplerSeed, args.light, args.pass);
    LightRecord light = args.lights.at[lightAsked(args.lights, args.lightCount, args.light, s, x.depth)];
    DirectLight toLight = directLight(light, args.light == kNone ? light.pmf : 1.0, x, lobe, s);
    bool asks = isWorthAsking(toLight);
    countAll(args.rayCount, asks ? 1u : 0u);
    if (asks && traceScene(args.rootNode, toLight.shadow, true).object == kNone) {
        args.direct.at[x.result] += toLight.contribution;
    }
}
