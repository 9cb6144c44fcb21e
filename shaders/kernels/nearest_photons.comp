#version 460
#extension GL_GOOGLE_include_directive : require
// Writes the results of photons/nearest.glsl themselves, so that tests can compare them with a brute-force search.
// reads: visible points, photon map
// writes: slots of the nearest photons
// threads: visible points
// computes: the photon search of estimate_radiance, for tests
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
        NearestQuery query = NearestQuery(x.position, tangentAt(x.position, x.geometricNormal, args.surfaceError),
                                       args.radius, args.nearest, args.kinds, x.depth,
                                          args.maxDepth, false);
        findNearest(args.map, query);
        sortNearest(args.map, query);
    }
    for (uint j = 0u; j < args.nearest; ++j) {
        args.found.at[i * args.nearest + j] = j < heapCount ? args.map.order.at[heapPhoton[j]] : kNone;
    }
}
