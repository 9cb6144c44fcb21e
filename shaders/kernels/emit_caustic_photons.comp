#version 460
#extension GL_GOOGLE_include_directive : require
// Emits the photons of the caustic map: picks a light in proportion to power and share, then a ray from it towards a
// specular object [Jensen01, ch. 5].
// reads: lights, targets
// writes: rays, photon paths
// threads: photons
// computes: the same, aimed at specular objects: Φ p / q, q the density over the cones [Jensen01]
#include "shared/kernel_arguments.h"
#include "photons/projection.glsl"
#include "lib/sampling.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { EmitCausticPhotonsArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    uint photon = args.first + i;
    Sampler s = photonSampler(args.sequence, photon);
    vec2 choice = sampleUnit(s, kPhotonLight);
    uint index = pickLight(args.lights, args.lightCount, choice.x);
    LightRecord light = args.lights.at[index];
    vec2 uOrigin = sampleUnit(s, kPhotonOrigin);
    vec2 uDirection = sampleUnit(s, kPhotonDirection);
    AimedRay ray = aimRay(light, args.targets, args.targetCount, emitFrom(light, uOrigin, uDirection), choice.y, uOrigin,
                          uDirection);
    vec3 power = ray.power / (light.pmf * float(args.ofPass));
    bool dark = maxComponent(power) <= 0.0; // the light does not emit in this direction: a ray of zero length
    args.rays.at[i] = Ray(ray.origin, dark ? 0.0 : kInfinity, ray.direction, 0u);
    args.paths.at[i] = PhotonPath(power, photon, index, kPhotonDirect, light.media);
}
