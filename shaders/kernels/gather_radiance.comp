#version 460
#extension GL_GOOGLE_include_directive : require
// Radiance estimate at every visible point: the flux of the photons in a disc about it, over the disc's area
// [Jensen01, ch. 7], here with a fixed radius.
#include "shared/kernel_arguments.h"
#include "lib/diffuse.glsl"
#include "lib/grid.glsl"
#include "lib/photon.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { GatherRadianceArguments args; };

// Flux of the photon that the coat lets in, if it counts for x, else 0.
vec3 photonFlux(VisiblePoint x, vec3 normal, uint photon) {
    vec4 place = texelFetch(photonTable, int(2u * photon));
    vec3 offset = place.xyz - x.position;
    if (dot(offset, offset) > args.radius * args.radius || abs(dot(offset, normal)) > kPlaneDistance * args.radius) {
        return vec3(0.0);
    }
    vec4 rest = texelFetch(photonTable, int(2u * photon + 1u));
    uint surface = floatBitsToUint(rest.w);
    uint direction = floatBitsToUint(place.w);
    if (!onSameSide(x.normal, direction, surface) || photonLength(surface) + x.depth > args.maxDepth) {
        return vec3(0.0);
    }
    if (x.coat == 0.0) {
        return rest.xyz;
    }
    return rest.xyz * diffuseFactor(x.coat, dot(normalize(unpackDirection(direction, kDirectionBits)), x.normal));
}

// The photons that a query has to look at: four rows of two cells, each row one range of the sorted photons, and what
// lies beyond the end of the table in the rare row that wraps around to bucket 0.
struct Ranges {
    uvec4 first;
    uvec4 end;
    uint wrappedEnd;
};

// A cell is as wide as the disc, which so reaches into two cells along each axis. Different cells may share a bucket:
// a bucket that an earlier row holds is left out of a later one, so that no photon is met twice.
Ranges candidateRanges(vec3 position) {
    ivec3 low = cellOf(position - args.radius, args.grid);
    uint mask = args.grid.bucketMask;
    uvec4 bucket;
    Ranges ranges;
    ranges.wrappedEnd = 0u;
    for (int row = 0; row < 4; ++row) {
        bucket[row] = cellBucket(low + ivec3(0, row & 1, row >> 1), mask);
        bool takeFirst = true, takeSecond = true;
        for (int earlier = 0; earlier < row; ++earlier) {
            uint ahead = (bucket[row] - bucket[earlier]) & mask;
            takeFirst = takeFirst && ahead != 0u && ahead != 1u;
            takeSecond = takeSecond && ahead != 0u && ahead != mask;
        }
        bool wraps = bucket[row] == mask;
        ranges.first[row] = args.cellStarts.at[bucket[row] + (takeFirst ? 0u : 1u)];
        ranges.end[row] = args.cellStarts.at[bucket[row] + (takeSecond && !wraps ? 2u : 1u)];
        if (wraps && takeSecond) {
            ranges.wrappedEnd = args.cellStarts.at[1];
        }
    }
    return ranges;
}

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    VisiblePoint x = args.visiblePoints.at[i];
    vec3 flux = vec3(0.0);
    if (x.depth != 0u) {
        vec3 normal = normalize(unpackDirection(x.geometricNormal, 16u));
        Ranges ranges = candidateRanges(x.position);
        // One loop over all rows: neighbouring threads stay together although their rows differ in length
        int row = 0;
        uint photon = ranges.first.x;
        uint end = ranges.end.x;
        while (true) {
            if (photon >= end) {
                if (++row > 4) {
                    break;
                }
                photon = row < 4 ? ranges.first[row] : 0u;
                end = row < 4 ? ranges.end[row] : ranges.wrappedEnd;
                continue;
            }
            flux += photonFlux(x, normal, photon++);
        }
    }
    args.gathered.at[i] = x.f * flux / (kPi * args.radius * args.radius);
}
