#version 460
#extension GL_GOOGLE_include_directive : require
// Radiance estimate at every visible point: the flux of the photons in the disc around it, over the disc's area
// [Jensen01, ch. 7]. The radius is fixed; the part of the disc that lies beyond the edges of the surface is subtracted
// from the area.
// reads: visible points, cell starts, photon table
// writes: gathered light
// threads: visible points
// computes: L = f Σ Φ / (π r²) [Jensen01], [Knaus11]
#include "shared/kernel_arguments.h"
#include "lights/receiver.glsl"
#include "photons/disc.glsl"
#include "photons/grid.glsl"
#include "photons/photon.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { GatherRadianceArguments args; };

// Bit i is set if photon `first` + i is within the radius; `count` is at most 32.
uint nearPhotons(vec3 position, uint first, uint count) {
    uint near = 0u;
    for (uint i = 0u; i < count; ++i) {
        vec3 offset = texelFetch(photonTable, int(2u * (first + i))).xyz - position;
        near |= uint(dot(offset, offset) <= args.radius * args.radius) << i;
    }
    return near;
}

// Flux of the photon times the transmittance of any layer over the diffuse part, if the photon counts for x, else 0.
// The photon is within the radius.
vec3 photonFlux(VisiblePoint x, Receiver receiver, Tangent tangent, Edge edge, uint photon) {
    vec4 place = texelFetch(photonTable, int(2u * photon));
    vec3 offset = place.xyz - x.position;
    vec4 rest = texelFetch(photonTable, int(2u * photon + 1u));
    uint surface = floatBitsToUint(rest.w);
    uint direction = floatBitsToUint(place.w);
    bool isFar = abs(dot(offset, tangent.normal)) > kPlaneDistance * args.radius;
    if (isFar || !onSameSurface(tangent, offset, surface) || !onSameSide(tangent.normal, direction) || photonLength(surface) + x.depth > args.maxDepth ||
        !isOnShape(edge, place.xyz)) {
        return vec3(0.0);
    }
    if (!receiver.isLayered) {
        return rest.xyz;
    }
    return rest.xyz * incidentFactor(receiver, clamp(dot(normalize(unpackDirection(direction, kDirectionBits)), x.normal), 0.0, 1.0));
}

void main() {
    uint i = threadPixel(args.width, args.count);
    if (i >= args.count) {
        return;
    }
    VisiblePoint x = args.visiblePoints.at[i];
    Receiver receiver;
    Edge edge;
    Tangent tangent;
    vec3 flux = vec3(0.0);
    if (x.depth != 0u) {
        tangent = tangentAt(x.position, x.geometricNormal, args.surfaceError);
        receiver = receiverAt(x, args.materials);
        edge = edgeAround(x.position, x.from, args.radius);
        CellWalk walk = walkCells(x.position, args.radius, args.radius * discExtent(tangent.normal), args.grid);
        uint photon = 0u, end = 0u;
        // Row by row: neighbouring threads stay in step because their discs, and so their rows, are nearly the same.
        // Only one photon in five is within the radius, but a different one for each thread of a subgroup: each thread
        // first lists its own.
        while (nextRange(walk, args.grid, args.cellStarts, photon, end)) {
            while (photon < end) {
                uint chunk = min(end - photon, 32u);
                uint near = nearPhotons(x.position, photon, chunk);
                while (near != 0u) {
                    flux += photonFlux(x, receiver, tangent, edge, photon + findLSB(near));
                    near &= near - 1u;
                }
                photon += chunk;
            }
        }
    }
    bool found = maxComponent(flux) > 0.0;
    args.gathered.at[i] = found ? receiver.f * flux / discArea(edge, x.position, tangent.normal, args.radius) : vec3(0.0);
}
