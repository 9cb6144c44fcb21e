#version 460
#extension GL_GOOGLE_include_directive : require
// Adds each light contribution whose shadow ray is unoccluded.
// reads: shadow rays, contributions, tables; where rays pass through glass, visible points and materials too
// writes: direct light
// threads: shadow rays
// computes: adds unoccluded contributions
#include "shared/kernel_arguments.h"
#include "lights/shadow.glsl"
#include "lib/counter.glsl"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { TraceShadowArguments args; };

void main() {
    uint count = liveCount(args.live, args.count);
    uint i = liveElement(args.width, count, args.count);
    if (i >= count) {
        return;
    }
    Ray ray = args.shadowRays.at[i];
    bool traces = ray.tMax > 0.0;
    countAll(args.rayCount, traces ? 1u : 0u);
    if (traces) {
        uint pixel = isSome(uvec2(args.paths)) ? args.paths.at[i].pixel : i;
        uint media = mediaNeed(kMediaShadows) ? args.visiblePoints.at[pixel].media : kNoMedia;
        vec3 share = lightPassing(args.rootNode, ray, media, args.materials, args.normals, args.instances);
        if (maxComponent(share) > 0.0) {
            args.direct.at[pixel] += args.contributions.at[i] * share;
        }
    }
}
