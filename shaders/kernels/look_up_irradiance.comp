#version 460
#extension GL_GOOGLE_include_directive : require
// Radiance that a gathering ray finds at the diffuse surface it hits: the irradiance of the nearest record
// [Christensen99], times the BSDF. A record counts on its own surface, within the disc of its estimate. Where none does,
// the point remains for an estimate of its own; a point that has found its light gets depth 0.
// reads: visible points, irradiance map
// writes: light found by gathering rays, visible points
// threads: visible points
// computes: L += f E of the nearest record on the surface [Christensen99]
#include "shared/kernel_arguments.h"
#include "lights/receiver.glsl"
#include "photons/nearest.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { LookUpIrradianceArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    VisiblePoint y = args.visiblePoints.at[i];
    if (y.depth == 0u) {
        return;
    }
    findNearest(args.map, NearestQuery(y.position, tangentAt(y.position, y.geometricNormal, args.surfaceError),
                                       args.radius, 1u, 0xfu, 0u, kMaxDepth, true));
    if (heapCount > 0u) {
        vec4 record = texelFetch(photonTable, int(2u * (args.map.base + heapPhoton[0]) + 1u));
        Receiver receiver = receiverAt(y, args.materials);
        // The irradiance's directions are unknown: assume it arrives uniformly from the hemisphere
        args.gathered.at[i] += (args.scale * meanOverDiffuse(receiver.material)) * receiver.f * record.xyz;
        args.visiblePoints.at[i].depth = 0u;
    }
}
