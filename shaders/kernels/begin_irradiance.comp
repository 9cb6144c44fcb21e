#version 460
#extension GL_GOOGLE_include_directive : require
// Turns the marked photons into visible points without a material: the radiance estimate there is the irradiance
// [Christensen99].
// reads: photons
// writes: visible points
// threads: photon slots
// computes: one photon in four becomes a place to estimate irradiance at [Christensen99]
#include "shared/kernel_arguments.h"
#include "photons/photon.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { BeginIrradianceArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    args.visiblePoints.at[i].depth = 0u;
    Photon photon = args.photons.at[i];
    if (photon.surface == kNone || (photon.direction & kMarkedPhoton) == 0u) {
        return;
    }
    vec3 normal = normalize(unpackDirection(photon.surface, kNormalBits));
    args.visiblePoints.at[i] =
        VisiblePoint(photon.position, 1u, normal, 0u, photon.position, 0u, normal, packUnitVector(normal, 16u),
                     vec3(1.0), i, vec2(0.0), kNone, 1.0, kNoMedia);
}
