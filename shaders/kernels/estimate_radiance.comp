#version 460
#extension GL_GOOGLE_include_directive : require
// Radiance estimate at every visible point from the k nearest photons [Jensen01, ch. 7]: the filter-weighted flux of
// the photons in a disc, over the integral of the filter. The disc's radius is the distance of the k-th photon, which
// is not counted: the k - 1 photons inside give an unbiased density; docs/photon-mapping.md has the proof.
// reads: visible points, photon map
// writes: gathered light, radii of the discs
// threads: visible points
// computes: L = f Σ w Φ / (∫w) over the disc of the k nearest [Jensen01]; see [photon
//     mapping](../../docs/photon-mapping.md)
#include "shared/kernel_arguments.h"
#include "photons/custom_filter.glsl"
#include "lights/receiver.glsl"
#include "photons/nearest.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { EstimateRadianceArguments args; };

// Smallest disc radius: photons exactly at the point would make a disc of zero area [largest radius].
const float kLeastDisc = 1.0 / 1024.0;

// The Gaussian's slope in [Jensen01]; the paper's leading factor cancels because the estimate divides by the filter's
// integral.
const float kGaussianBeta = 1.953;

// Number of intervals of [0, 1] used to integrate a custom filter.
const uint kFilterParts = 32u;

// Number of photons in the smallest disc that is checked for an edge.
const uint kFirstCheck = 8u;

// The first `count` photons of the heap, in a disc of this radius.
struct Disc {
    float radius;
    uint count;
};

vec4 photonTexel(uint found, uint texel) {
    return texelFetch(photonTable, int(2u * (args.map.base + heapPhoton[found]) + texel));
}

// Flux of one of the photons found, times the transmittance of any layer over the diffuse part; 0 if the photon lies
// too far off the tangent plane with this normal to be on the same surface.
vec3 fluxInDisc(uint found, VisiblePoint x, Receiver receiver, vec3 normal, float radius) {
    vec4 place = photonTexel(found, 0u);
    if (abs(dot(place.xyz - x.position, normal)) > kPlaneDistance * radius) {
        return vec3(0.0);
    }
    vec3 power = photonTexel(found, 1u).xyz;
    if (!receiver.isLayered) {
        return power;
    }
    vec3 direction = normalize(unpackDirection(floatBitsToUint(place.w), kDirectionBits));
    return power * incidentFactor(receiver, dot(direction, x.normal));
}

// Filter weight; 1 at the centre.
float weight(float distance2, float radius2) {
    float u = distance2 / radius2;
    if (args.filterKind == kFilterCone) {
        return 1.0 - sqrt(u) / args.filterConstant;
    }
    if (args.filterKind == kFilterGaussian) {
        float end = exponential(-kGaussianBeta);
        return (exponential(-0.5 * kGaussianBeta * u) - end) / (1.0 - end);
    }
    if (args.filterKind == kFilterCustom) {
        return customFilter(u);
    }
    return 1.0;
}

// Mean filter weight over the disc.
float meanWeight() {
    if (args.filterKind == kFilterCone) {
        return 1.0 - 2.0 / (3.0 * args.filterConstant);
    }
    if (args.filterKind == kFilterGaussian) {
        float end = exponential(-kGaussianBeta);
        return ((1.0 - exponential(-0.5 * kGaussianBeta)) * 2.0 / kGaussianBeta - end) / (1.0 - end);
    }
    if (args.filterKind == kFilterCustom) { // u is uniform on [0, 1] over the disc: midpoint rule
        float sum = 0.0;
        for (uint i = 0u; i < kFilterParts; ++i) {
            sum += customFilter((float(i) + 0.5) / float(kFilterParts));
        }
        return sum / float(kFilterParts);
    }
    return 1.0;
}

// Differential checking, after [Jensen95]: grows a disc through the photons, a quarter of their number at a time. If
// the density (sum of the channels) has risen or fallen monotonically by more than maxChange, relative to its value at
// the start of that trend, the disc has crossed an edge; the answer is the disc where the trend started.
Disc stopAtEdge(Disc whole, VisiblePoint x, Receiver receiver, vec3 normal) {
    Disc start = whole;    // where the present rise or fall of the density started
    Disc previous = whole; // the disc of the step before
    float startDensity = 0.0, previousDensity = 0.0, flux = 0.0;
    bool rises = false;
    uint next = kFirstCheck;
    for (uint i = 0u; i < whole.count; ++i) {
        if (i == next) {
            Disc disc = Disc(max(sqrt(heapDistance2[i]), kLeastDisc * args.radius), i);
            float density = flux / (disc.radius * disc.radius);
            if (i == kFirstCheck) {
                start = disc;
                startDensity = density;
            } else {
                if (start.count == previous.count || (density > previousDensity) != rises) {
                    start = previous;
                    startDensity = previousDensity;
                    rises = density > previousDensity;
                }
                if (startDensity > 0.0 && abs(density - startDensity) > args.maxChange * startDensity) {
                    return start;
                }
            }
            previous = disc;
            previousDensity = density;
            next = i + (i + 3u) / 4u;
        }
        vec3 power = fluxInDisc(i, x, receiver, normal, whole.radius);
        flux += power.x + power.y + power.z;
    }
    return whole;
}

void main() {
    uint i = threadPixel(args.width, args.count);
    if (i >= args.count) {
        return;
    }
    VisiblePoint x = args.visiblePoints.at[i];
    if (x.depth == 0u) {
        args.gathered.at[i] = vec3(0.0);
        args.radii.at[i] = 0.0;
        return;
    }
    Receiver receiver = receiverAt(x, args.materials);
    NearestQuery query =
        NearestQuery(x.position, x.normal, args.radius, args.nearest, args.kinds, x.depth, args.maxDepth);
    findNearest(args.map, query);
    sortNearest(args.map, query); // so that the sum below has the same order for both search structures
    Disc disc = Disc(args.radius, heapCount);
    if (heapCount == args.nearest) {
        --disc.count;
        disc.radius = max(sqrt(heapDistance2[disc.count]), kLeastDisc * args.radius);
    }
    vec3 normal = normalize(unpackDirection(x.geometricNormal, 16u));
    if (args.maxChange > 0.0) {
        disc = stopAtEdge(disc, x, receiver, normal);
    }
    float radius2 = disc.radius * disc.radius;
    vec3 flux = vec3(0.0);
    for (uint j = 0u; j < disc.count; ++j) {
        flux += weight(heapDistance2[j], radius2) * fluxInDisc(j, x, receiver, normal, disc.radius);
    }
    args.gathered.at[i] = receiver.f * flux / (meanWeight() * kPi * radius2);
    args.radii.at[i] = disc.radius;
}
