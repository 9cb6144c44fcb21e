#version 460
#extension GL_GOOGLE_include_directive : require
// Final gathering: one ray from each visible point, with density cos / pi.
// reads: visible points
// writes: rays, camera paths, alive flags
// threads: visible points
// computes: final gathering: f cos / (cos / π) [Jensen96]
#include "shared/kernel_arguments.h"
#include "lights/receiver.glsl"
#include "lib/sampling.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { StartGatherRaysArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    args.alive.at[i] = 0u;
    VisiblePoint x = args.visiblePoints.at[i];
    if (x.depth == 0u) {
        return;
    }
    uint sequence = gatherSequence(x.samplerSeed);
    vec3 direction = cosineHemisphere(sampleUnit(pathSampler(sequence, args.pass), kGatherDirection), x.normal);
    if (dot(direction, unpackDirection(x.geometricNormal, 16u)) <= 0.0) {
        return; // the smoothed normal tilts below the geometric surface: no light comes from inside
    }
    args.rays.at[i] = Ray(x.position, kInfinity, direction, x.from);
    Receiver receiver = receiverAt(x, args.materials);
    vec3 beta = receiver.f * (kPi * incidentFactor(receiver, dot(direction, x.normal))); // f cos / (cos / pi)
    args.paths.at[i] = CameraPath(beta, x.pixel, sequence, x.media, 0.0);
    args.alive.at[i] = 1u;
}
