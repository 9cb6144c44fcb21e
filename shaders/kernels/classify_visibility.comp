#version 460
#extension GL_GOOGLE_include_directive : require
// Decides from the photons around a visible point which lights are visible there. A light is visible if enough photons
// are near and all are direct; it is occluded if all are shadow photons; otherwise a shadow ray decides
// [JensenChristensen95].
// reads: visible points, shadow map
// writes: visible lights, occluded lights
// threads: visible points
// computes: visible or occluded where all photons of a light nearby agree [JensenChristensen95]
#include "shared/kernel_arguments.h"
#include "photons/nearest.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { ClassifyVisibilityArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    args.lit.at[i] = 0u;
    args.shadowed.at[i] = 0u;
    VisiblePoint x = args.visiblePoints.at[i];
    if (x.depth == 0u) {
        return;
    }
    uint kinds = (1u << kPhotonDirect) | (1u << kPhotonShadow);
    findNearest(args.map, NearestQuery(x.position, tangentAt(x.position, x.geometricNormal, args.surfaceError),
                                       args.radius, args.nearest, kinds, 0u, kMaxDepth,
                                       false));
    uint direct[kMostClassifiedLights];
    uint shadow[kMostClassifiedLights];
    for (uint light = 0u; light < kMostClassifiedLights; ++light) {
        direct[light] = 0u;
        shadow[light] = 0u;
    }
    for (uint j = 0u; j < heapCount; ++j) {
        vec4 rest = texelFetch(photonTable, int(2u * (args.map.base + heapPhoton[j]) + 1u));
        uint surface = floatBitsToUint(rest.w);
        uint light = surface >> kLengthShift;
        if (light >= kMostClassifiedLights) {
            continue;
        }
        if (photonKind(surface) == kPhotonDirect) {
            ++direct[light];
        } else {
            ++shadow[light];
        }
    }
    uint lit = 0u;
    uint shadowed = 0u;
    for (uint light = 0u; light < min(args.lightCount, kMostClassifiedLights); ++light) {
        if (direct[light] >= args.agreeing && shadow[light] == 0u) {
            lit |= 1u << light;
        } else if (shadow[light] >= args.agreeing && direct[light] == 0u) {
            shadowed |= 1u << light;
        }
    }
    args.lit.at[i] = lit;
    args.shadowed.at[i] = shadowed;
}
