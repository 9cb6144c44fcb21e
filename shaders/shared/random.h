// Counter-based random numbers, the same bits in C++ and GLSL: a sampler names a sequence and an index in it, a
// dimension picks a pair of numbers there. The pairs are Owen-scrambled Sobol points, shuffled per dimension so that
// dimensions can be padded [Burley20]; the second Sobol coordinate is Pascal's matrix mod 2, in five steps [Ahmed24].
// Alternatively they are independent hashes of their place, to measure the gain of the Sobol points.
#ifndef HYALITE_SHARED_RANDOM_H
#define HYALITE_SHARED_RANDOM_H
#include "language.h"
SHARED_BEGIN

// Full-avalanche 32-bit integer hash ("lowbias32", C. Wellons).
SHARED_FUNCTION uint hash(uint x) {
    x ^= x >> 16u;
    x *= 0x7feb352du;
    x ^= x >> 15u;
    x *= 0x846ca68bu;
    return x ^ (x >> 16u);
}

SHARED_FUNCTION uint hashCombine(uint seed, uint value) {
    return hash(seed ^ (value * 0x9e3779b9u + 0x85ebca6bu));
}

SHARED_FUNCTION uint reverseBits(uint x) {
    x = (x >> 16u) | (x << 16u);
    x = ((x & 0x00ff00ffu) << 8u) | ((x & 0xff00ff00u) >> 8u);
    x = ((x & 0x0f0f0f0fu) << 4u) | ((x & 0xf0f0f0f0u) >> 4u);
    x = ((x & 0x33333333u) << 2u) | ((x & 0xccccccccu) >> 2u);
    return ((x & 0x55555555u) << 1u) | ((x & 0xaaaaaaaau) >> 1u);
}

// Owen scrambling of the bit-reversed x: a hash of the lower bits alone decides whether to flip each bit (the improved
// Laine-Karras permutation of [Burley20], with constants found by N. Vegdahl).
SHARED_FUNCTION uint scrambleReversed(uint x, uint seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16u) | 1u;
    x ^= x * 0x05526c56u;
    return x ^ (x * 0x53a22864u);
}

// Generator matrix of the second Sobol dimension: binomial(j, k) mod 2, a Kronecker power of (1 1; 0 1).
SHARED_FUNCTION uint pascal(uint x) {
    x ^= x >> 16u;
    x ^= (x & 0xff00ff00u) >> 8u;
    x ^= (x & 0xf0f0f0f0u) >> 4u;
    x ^= (x & 0xccccccccu) >> 2u;
    return x ^ ((x & 0xaaaaaaaau) >> 1u);
}

// One path's index in its sequence.
struct Sampler {
    uint seed;  // names the sequence; the lowest bit says which kind of numbers it has
    uint index; // index in it: successive indices fill the unit square evenly
};

SHARED_CONSTANT kSobolNumbers = 0u;
SHARED_CONSTANT kIndependentNumbers = 1u;

// The seed of all sequences of a picture. A distinct type, so that no plain number is mistaken for it.
struct RenderSeed {
    uint sequence;
};

// `seed` is the user's.
SHARED_FUNCTION RenderSeed renderSeed(uint seed, uint numbers) {
    RenderSeed s;
    s.sequence = (hash(seed) & ~1u) | numbers;
    return s;
}

// The seed of one of a sequence's many child sequences, with the same kind of numbers.
SHARED_FUNCTION uint deriveSequence(uint sequence, uint value) {
    return (hashCombine(sequence, value) & ~1u) | (sequence & 1u);
}

// Camera paths: each pixel has kCameraSequences independent sequences, which take turns with the passes; the means of
// each over its passes give an estimate of the error.
SHARED_CONSTANT kCameraSequences = 2u;

// The sampler of a path with this `samplerSeed`, in a pass.
SHARED_FUNCTION Sampler pathSampler(uint samplerSeed, uint pass) {
    Sampler s;
    s.seed = samplerSeed;
    s.index = pass / kCameraSequences;
    return s;
}

SHARED_FUNCTION Sampler cameraSampler(RenderSeed seed, uint pass, uint pixel) {
    uint sequences = deriveSequence(deriveSequence(seed.sequence, 0u), pass % kCameraSequences);
    return pathSampler(deriveSequence(sequences, pixel), pass);
}

// Photon paths: one sequence per pass and purpose, whose successive points are the photons emitted.
SHARED_CONSTANT kGlobalPhotons = 1u;
SHARED_CONSTANT kCausticPhotons = 2u;
SHARED_CONSTANT kShadowPhotons = 3u;

SHARED_FUNCTION uint photonSequence(RenderSeed seed, uint purpose, uint pass) {
    return deriveSequence(deriveSequence(seed.sequence, purpose), pass);
}

SHARED_FUNCTION Sampler photonSampler(uint sequence, uint photon) {
    Sampler s;
    s.seed = sequence;
    s.index = photon;
    return s;
}

// Two 32-bit fractions for a dimension of the sampler.
SHARED_FUNCTION uvec2 sampleBits(Sampler s, uint dimension) {
    uint dimensionSeed = hashCombine(s.seed, dimension);
    if ((s.seed & 1u) == kIndependentNumbers) {
        return uvec2(hashCombine(dimensionSeed, s.index), hashCombine(hash(dimensionSeed ^ 0x2c1b3c6du), s.index));
    }
    uint shuffled = reverseBits(scrambleReversed(reverseBits(s.index), dimensionSeed));
    uint x = reverseBits(scrambleReversed(shuffled, hash(dimensionSeed ^ 0x68bc21ebu)));
    uint y = reverseBits(scrambleReversed(pascal(shuffled), hash(dimensionSeed ^ 0x02e5be93u)));
    return uvec2(x, y);
}

// The dimension of each random decision along a path. Vertices are counted from 0, the first hit.
SHARED_CONSTANT kCameraPixel = 0u; // position in the pixel
SHARED_CONSTANT kCameraLens = 1u;  // position on the lens

SHARED_FUNCTION uint cameraScatter(uint vertex) { // x: reflected or refracted, by lobe or diffuse part
    return 2u + 4u * vertex;
}
SHARED_FUNCTION uint cameraLightPoint(uint vertex) { // point on the light
    return 3u + 4u * vertex;
}
SHARED_FUNCTION uint cameraLightChoice(uint vertex) { // x: which light
    return 4u + 4u * vertex;
}
SHARED_FUNCTION uint cameraBounce(uint vertex) { // direction off a rough surface
    return 5u + 4u * vertex;
}

// Final gathering: the rays from a visible point have their own sequence …
SHARED_FUNCTION uint gatherSequence(uint samplerSeed) {
    return deriveSequence(samplerSeed, 64u);
}
// … and their own passes: the gather rays of a pass have the indices (index of the pass) rays + ray.
SHARED_FUNCTION uint gatherPass(uint pass, uint rays, uint ray) {
    return (pass / kCameraSequences * rays + ray) * kCameraSequences + pass % kCameraSequences;
}
SHARED_CONSTANT kGatherDirection = 0u;

// Path tracing continues from diffuse surfaces, with dimensions beyond those of the longest path above.
SHARED_CONSTANT kPathFirst = 1024u;

SHARED_FUNCTION uint pathBounce(uint vertex) { // direction after a diffuse reflection
    return kPathFirst + 8u * vertex;
}
SHARED_FUNCTION uint pathRoulette(uint vertex) { // x: does the path survive
    return kPathFirst + 8u * vertex + 1u;
}

SHARED_CONSTANT kPhotonLight = 0u;     // x: which light emits, y: which target it aims at
SHARED_CONSTANT kPhotonOrigin = 1u;    // point on the light
SHARED_CONSTANT kPhotonDirection = 2u; // direction of emission

SHARED_FUNCTION uint photonScatter(uint vertex) { // x: roulette, y: reflected or refracted, by lobe or diffuse part
    return 3u + 2u * vertex;
}
SHARED_FUNCTION uint photonBounce(uint vertex) { // direction off a diffuse or rough surface
    return 4u + 2u * vertex;
}

SHARED_END
#endif
