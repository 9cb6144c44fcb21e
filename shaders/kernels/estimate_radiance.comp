#version 460
#extension GL_GOOGLE_include_directive : require
// Radiance estimate at every visible point from the k nearest photons [Jensen01, ch. 7]: the filter-weighted flux of
// the photons in a disc, over the integral of the filter. The disc's radius is the distance of the k-th photon, which
// is not counted: the k - 1 photons inside give an unbiased density; docs/photon-mapping.md has the proof. In a focus,
// where that disc would be smaller than a pixel, all photons within a pixel's radius count instead, however many.
// reads: visible points, photon map
// writes: gathered light, radii of the discs
// threads: visible points
// computes: L = f Σ w Φ / (∫w) over the disc of the k nearest [Jensen01]; see [photon
//     mapping](../../docs/photon-mapping.md)
#include "shared/kernel_arguments.h"
#include "photons/custom_filter.glsl"
#include "lights/receiver.glsl"
#include "photons/disc.glsl"
#include "photons/nearest.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { EstimateRadianceArguments args; };

// Smallest disc radius of any camera: photons exactly at the point would make a disc of zero area [largest radius].
const float kLeastDisc = 1.0 / 1048576.0;

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

// Flux of a photon of the map, times the transmittance of any layer over the diffuse part; 0 if the photon lies beyond
// the edge or too far off the tangent plane with this normal to be on the same surface.
vec3 fluxInDisc(uint photon, VisiblePoint x, Receiver receiver, vec3 normal, Edge edge, float radius) {
    vec4 place = texelFetch(photonTable, int(2u * (args.map.base + photon)));
    if (abs(dot(place.xyz - x.position, normal)) > kPlaneDistance * radius || !isOnShape(edge, place.xyz)) {
        return vec3(0.0);
    }
    vec3 power = texelFetch(photonTable, int(2u * (args.map.base + photon) + 1u)).xyz;
    if (!receiver.isLayered) {
        return power;
    }
    vec3 direction = normalize(unpackDirection(floatBitsToUint(place.w), kDirectionBits));
    return power * incidentFactor(receiver, clamp(dot(direction, x.normal), 0.0, 1.0));
}

// The smallest disc: it covers a pixel, so that camera rays cannot miss a focus between them.
float leastRadius(vec3 position) {
    return lesser(args.radius, greater(args.footprint * length(position - args.eye), kLeastDisc * args.radius));
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

// Filter-weighted flux of a photon within the smallest disc; 0 if it does not count. `place`: its first texel.
vec3 weightedFlux(NearestQuery query, VisiblePoint x, Receiver receiver, Edge edge, float radius, uint photon,
                  vec4 place) {
    vec3 way = place.xyz - query.position;
    float distance2 = dot(way, way);
    if (distance2 > radius * radius) {
        return vec3(0.0);
    }
    uint surface = floatBitsToUint(texelFetch(photonTable, int(2u * (args.map.base + photon) + 1u)).w);
    if (!counts(query, way, distance2, floatBitsToUint(place.w), surface)) {
        return vec3(0.0);
    }
    return weight(distance2, radius * radius) * fluxInDisc(photon, x, receiver, query.tangent.normal, edge, radius);
}

// The sum of all of them: there may be as many as the map holds, so each addition keeps what it rounds off [Kahan65].
struct LongSum {
    vec3 sum;
    vec3 rest;
};

LongSum added(LongSum total, vec3 term) {
    precise vec3 more = term - total.rest;
    precise vec3 sum = total.sum + more;
    precise vec3 rest = (sum - total.sum) - more;
    return LongSum(sum, rest);
}

vec3 fluxWithin(NearestQuery query, VisiblePoint x, Receiver receiver, Edge edge, float radius) {
    LongSum total = LongSum(vec3(0.0), vec3(0.0));
    if (kPhotonStructure == kPhotonTree) {
        uint top = 0u;
        uint node = 0u;
        while (node < args.map.count) {
            vec4 place = texelFetch(photonTable, int(2u * (args.map.base + node)));
            total = added(total, weightedFlux(query, x, receiver, edge, radius, node, place));
            node = nextNode(node, query.position, place, args.map.count, radius * radius, top);
        }
        return total.sum;
    }
    CellWalk walk = walkCells(query.position, radius, vec3(radius), args.map.grid);
    uint photon = 0u, end = 0u;
    while (nextRange(walk, args.map.grid, args.map.cellStarts, photon, end)) {
        for (; photon < end; ++photon) {
            vec4 place = texelFetch(photonTable, int(2u * (args.map.base + photon)));
            if (isOfRow(walk, place.xyz, args.map.grid)) {
                total = added(total, weightedFlux(query, x, receiver, edge, radius, photon, place));
            }
        }
    }
    return total.sum;
}

// Differential checking, after [Jensen95]: grows a disc through the photons, a quarter of their number at a time. If
// the density (sum of the channels) has risen or fallen monotonically by more than maxChange, relative to its value at
// the start of that trend, the disc has crossed an edge; the answer is the disc where the trend started.
Disc stopAtEdge(Disc whole, float least, VisiblePoint x, Receiver receiver, vec3 normal, Edge edge) {
    Disc start = whole;    // where the present rise or fall of the density started
    Disc previous = whole; // the disc of the step before
    float startDensity = 0.0, previousDensity = 0.0, flux = 0.0;
    bool rises = false;
    uint next = kFirstCheck;
    bool isFirst = true;
    for (uint i = 0u; i < whole.count; ++i) {
        if (i == next && heapDistance2[i] < least * least) {
            ++next; // still smaller than the smallest disc
        }
        if (i == next) {
            Disc disc = Disc(sqrt(heapDistance2[i]), i);
            float density = flux / (disc.radius * disc.radius);
            if (isFirst) {
                isFirst = false;
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
        vec3 power = fluxInDisc(heapPhoton[i], x, receiver, normal, edge, whole.radius);
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
    Tangent tangent = tangentAt(x.position, x.geometricNormal, args.surfaceError);
    vec3 normal = tangent.normal;
    NearestQuery query = NearestQuery(x.position, tangent, args.radius, args.nearest, args.kinds, x.depth,
                                      args.maxDepth, false);
    findNearest(args.map, query);
    sortNearest(args.map, query); // so that the sum below has the same order for both search structures
    float least = leastRadius(x.position);
    Disc disc = Disc(args.radius, heapCount);
    if (heapCount == args.nearest) {
        --disc.count;
        disc.radius = sqrt(heapDistance2[disc.count]);
    }
    Edge edge = edgeAround(x.position, x.from, max(disc.radius, least));
    vec3 flux = vec3(0.0);
    if (disc.radius < least) {
        disc.radius = least;
        flux = fluxWithin(query, x, receiver, edge, least);
    } else {
        if (args.maxChange > 0.0) {
            disc = stopAtEdge(disc, least, x, receiver, normal, edge);
        }
        float radius2 = disc.radius * disc.radius;
        for (uint j = 0u; j < disc.count; ++j) {
            flux += weight(heapDistance2[j], radius2) * fluxInDisc(heapPhoton[j], x, receiver, normal, edge, disc.radius);
        }
    }
    args.gathered.at[i] = receiver.f * flux / (meanWeight() * discArea(edge, x.position, normal, disc.radius));
    args.radii.at[i] = disc.radius;
}
