#version 460
#extension GL_GOOGLE_include_directive : require
// Radiance estimate at every visible point: the flux of the photons in a disc about it, over the disc's area
// [Jensen01, eq. 7.7 with a fixed radius].
#include "shared/kernel_arguments.h"
#include "lib/grid.glsl"
#include "lib/math.glsl"
#include "lib/tables.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { GatherRadianceArguments args; };

// Photons farther than this from the tangent plane, in search radii, lie on another surface.
const float kPlaneDistance = 0.25;
// So do photons whose surface is turned away by more than 60 degrees.
const float kNormalCosine = 0.5;

vec3 photonFlux(VisiblePoint x, uint photon) {
    vec4 place = texelFetch(photonTable, int(2u * photon));
    vec3 offset = place.xyz - x.position;
    if (dot(offset, offset) > args.radius * args.radius || abs(dot(offset, x.normal)) > kPlaneDistance * args.radius) {
        return vec3(0.0);
    }
    vec4 rest = texelFetch(photonTable, int(2u * photon + 1u));
    uint surface = floatBitsToUint(rest.w);
    bool sameSurface = dot(unpackUnitVector(surface, 12u), x.normal) > kNormalCosine;
    bool fromAbove = dot(unpackUnitVector(floatBitsToUint(place.w), 16u), x.normal) > 0.0;
    bool shortEnough = (surface >> 24u) + x.depth <= args.maxDepth;
    return sameSurface && fromAbove && shortEnough ? rest.xyz : vec3(0.0);
}

// Sums over two x neighbours at once, whose buckets follow one another. Other cells may share the buckets: the cell
// of each photon is checked, so that none counts twice.
vec3 sumRow(VisiblePoint x, ivec3 cell) {
    uint bucket = cellBucket(cell, args.grid.bucketMask);
    uint next = (bucket + 1u) & args.grid.bucketMask;
    bool wraps = next == 0u;
    vec3 sum = vec3(0.0);
    for (uint part = 0u; part < (wraps ? 2u : 1u); ++part) {
        uint first = args.cellStarts.at[part == 0u ? bucket : 0u];
        uint end = args.cellStarts.at[part == 0u ? (wraps ? bucket : next) + 1u : 1u];
        for (uint photon = first; photon < end; ++photon) {
            vec3 flux = photonFlux(x, photon);
            if (flux != vec3(0.0)) {
                vec3 position = texelFetch(photonTable, int(2u * photon)).xyz;
                ivec3 home = cellOf(position, args.grid);
                if (home.yz == cell.yz && (home.x == cell.x || home.x == cell.x + 1)) {
                    sum += flux;
                }
            }
        }
    }
    return sum;
}

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    VisiblePoint x = args.visiblePoints.at[i];
    vec3 flux = vec3(0.0);
    if (x.depth != 0u) {
        // A cell is as wide as the disc: it reaches into two cells along each axis
        ivec3 low = cellOf(x.position - args.radius, args.grid);
        for (int y = 0; y < 2; ++y) {
            for (int z = 0; z < 2; ++z) {
                flux += sumRow(x, low + ivec3(0, y, z));
            }
        }
    }
    args.gathered.at[i] = x.f * flux / (kPi * args.radius * args.radius);
}
