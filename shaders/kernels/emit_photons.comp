#version 460
#extension GL_GOOGLE_include_directive : require
// Emits the photons of a pass: picks a light in proportion to power and share, then a ray from it [Jensen01, ch. 5].
// reads: lights
// writes: rays, photon paths
// threads: photons
// computes: Φ / (pmf N) each; density of rays in proportion to the flux [Jensen01]
#include "shared/kernel_arguments.h"
#include "lights/light.glsl"
#include "lib/sampling.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { EmitPhotonsArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    uint photon = args.first + i;
    Sampler s = photonSampler(args.sequence, photon);
    uint index = pickLight(args.lights, args.lightCount, s, kPhotonLight);
    LightRecord light = args.lights.at[index];
    LightRay ray = emitFrom(light, sampleUnit(s, kPhotonOrigin), sampleUnit(s, kPhotonDirection));
    args.rays.at[i] = Ray(startOf(ray), kInfinity, ray.direction, 0u);
    vec3 power = ray.power / (light.pmf * float(args.ofPass));
    args.paths.at[i] = PhotonPath(power, photon, index, kPhotonDirect, light.media);
}
