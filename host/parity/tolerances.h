// Tolerances for the difference of the two sides, with a reason for each: the table of docs/parity.md, which a test
// compares with this file.
#pragma once

#include <array>
#include <string_view>

namespace hyalite::parity {

struct Tolerance {
    std::string_view of;     // what it applies to
    double relative = 0;     // largest allowed error relative to the scale
    std::string_view scale;  // what errors are relative to, in words
    std::string_view reason; // for the value
};

inline constexpr Tolerance kEqual{"integers, indices, decisions", 0, "–", "integers and decisions are equal or not"};
inline constexpr Tolerance kSame{"copies", 0, "–", "a copy: the same bits"};
inline constexpr Tolerance kPosition{
    "positions, distances", 0x1p-18, "the largest coordinate of scene and camera",
    "positions on curved and transformed shapes are accurate to 2^-20 of the coordinates that they are computed from "
    "(shapes/surface.glsl); the length of the ray and the offset from the surface each add as much"};
inline constexpr Tolerance kDirection{"directions", 0x1p-20, "1", "a dozen roundings of components below 1"};
inline constexpr Tolerance kNormal{"normals", 0x1p-14, "1",
                                   "the position's error over the shape's radius: 2^-20 of the scene over 1/64 of it"};
inline constexpr Tolerance kBounce{"directions after a bounce", 0x1p-13, "1",
                                   "a bounce doubles the angular error of the normal"};
inline constexpr Tolerance kSampled{
    "sampled directions", 0x1p-13, "1",
    "the third component of a sampled direction is the root of a difference from 1, which keeps half the digits for "
    "grazing directions"};
inline constexpr Tolerance kWeight{
    "throughput, flux, light", 0x1p-15, "itself",
    "products of some dozens of terms, each accurate to 2^-24, and cosines with the direction's error"};
inline constexpr Tolerance kDensity{
    "densities and light of microfacets", 0x1p-10, "itself, or 1",
    "densities of microfacets: squares and fourth powers of cosines with the direction's error"};
inline constexpr Tolerance kSide{
    "sides of surfaces, packed", 0x1.2p-14, "1",
    "octahedral, 16 bits per coordinate: half a step of 2/65535 in x and y is up to one step in z, on a vector of "
    "length at least 1/sqrt(3)"};
inline constexpr Tolerance kPhotonDirection{"directions of photons, packed", 0x1.2p-13, "1",
                                            "octahedral, 15 bits per coordinate"};
inline constexpr Tolerance kPhotonNormal{
    "normals of photons, packed", 0x1.12p-9, "1",
    "octahedral, 11 bits per coordinate: half a step of 2/2047 in x and y is up to one step in z, on a vector of "
    "length at least 1/sqrt(3)"};
inline constexpr Tolerance kSum{
    "sums over photons and paths", 0x1p-15, "itself",
    "a sum of hundreds of positive terms in a different order: each addition rounds by 2^-24 of the sum"};
inline constexpr Tolerance kDisc{
    "radii of discs", 0x1p-15, "itself",
    "the distance to one photon: a difference of coordinates, for a disc of a hundredth of the scene"};
inline constexpr Tolerance kMean{"standard errors", 0x1p-20, "the mean",
                                 "a dozen roundings of sums over layers and of the difference of their means"};
inline constexpr Tolerance kRounding{"one operation", 0x1p-22, "itself, or 1", "one or two operations"};

// In the order of the documentation's table.
inline constexpr std::array<const Tolerance*, 16> kTolerances{
    &kEqual,   &kSame, &kPosition,        &kDirection,    &kNormal, &kBounce, &kSampled, &kWeight,
    &kDensity, &kSide, &kPhotonDirection, &kPhotonNormal, &kSum,    &kDisc,   &kMean,    &kRounding};

// What rounding may decide differently.
inline constexpr std::string_view kEdge = "edge, silhouette, or surfaces in one place";
inline constexpr std::string_view kDecision = "random decision at its threshold";
inline constexpr std::string_view kGrazing = "grazing or ill-conditioned";
inline constexpr std::string_view kRim = "photon on the rim of the disc";

} // namespace hyalite::parity
