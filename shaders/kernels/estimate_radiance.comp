#version 460
#extension GL_GOOGLE_include_directive : require
// Radiance estimate at every visible point from the k nearest photons [Jensen01, ch. 7]: the flux of those in a disc,
// weighted by a filter, over the integral of the filter. The disc reaches to the k-th photon, which itself is left out:
// k - 1 photons in a disc that the k-th ends estimate the density without bias; docs/photon-mapping.md has the proof.
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

// Photons that lie at the point itself would make a disc without area [largest radius].
const float kLeastDisc = 1.0 / 1024.0;

// The Gaussian's slope in [Jensen01]; the factor in front of it there drops out, as its integral is divided by.
const float kGaussianBeta = 1.953;

// Parts of [0, 1] that a custom filter's mean is summed over.
const uint kFilterParts = 32u;

// Photons of the smallest disc that is looked at for changes.
const uint kFirstCheck = 8u;

// The photons of the heap before `count`, in a disc of this radius.
struct Disc {
    float radius;
    uint count;
};

vec4 photonTexel(uint found, uint texel) {
    return texelFetch(photonTable, int(2u * (args.map.base + heapPhoton[found]) + texel));
}

// Flux of one of the photons found that what lies over the diffuse part lets in, or 0 if it is too far off the tangent
// plane, with this normal, to lie on the same surface.
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

// 1 at the centre.
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

// Mean of the weight over the disc.
float meanWeight() {
    if (args.filterKind == kFilterCone) {
        return 1.0 - 2.0 / (3.0 * args.filterConstant);
    }
    if (args.filterKind == kFilterGaussian) {
        float end = exponential(-kGaussianBeta);
        return ((1.0 - exponential(-0.5 * kGaussianBeta)) * 2.0 / kGaussianBeta - end) / (1.0 - end);
    }
    if (args.filterKind == kFilterCustom) { // over the disc u is even on [0, 1]: the midpoint rule
        float sum = 0.0;
        for (uint i = 0u; i < kFilterParts; ++i) {
            sum += customFilter((float(i) + 0.5) / float(kFilterParts));
        }
        return sum / float(kFilterParts);
    }
    return 1.0;
}

// Differential checking, after [Jensen95]: lets a disc grow through the photons by a quarter of their number at a time.
// Where the density, the sum of the channels, has risen or fallen without a turn by more than maxChange of what it was
// when it began to, an edge has been met, and the disc from which on it rose or fell is the answer.
Disc stopAtEdge(Disc whole, VisiblePoint x, Receiver receiver, vec3 normal) {
    Disc start = whole;    // from which on the density rises or falls
    Disc previous = whole; // the one before
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
    sortNearest(args.map, query); // so that the sum below has one order in every structure
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
