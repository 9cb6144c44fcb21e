#version 460
#extension GL_GOOGLE_include_directive : require
// The answers of photons/nearest.glsl themselves, so that they can be compared with those of asking every photon.
// reads: visible points, photon map
// writes: slots of the nearest photons
// threads: visible points
// computes: asked by tests; the search of estimate_radiance
#include "shared/kernel_arguments.h"
#include "photons/nearest.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { NearestPhotonsArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    VisiblePoint x = args.visiblePoints.at[i];
    heapCount = 0u;
    if (x.depth != 0u) {
        NearestQuery query =
            NearestQuery(x.position, x.normal, args.radius, args.nearest, args.kinds, x.depth, args.maxDepth);
        findNearest(args.map, query);
        sortNearest(args.map, query);
    }
    for (uint j = 0u; j < args.nearest; ++j) {
        args.found.at[i * args.nearest + j] = j < heapCount ? args.map.order.at[heapPhoton[j]] : kNone;
    }
}
