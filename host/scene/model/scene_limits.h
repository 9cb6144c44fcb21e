// The largest and smallest values a scene file may hold, each with its reason. The kernels compute in 32-bit floats:
// the reader rejects values that they would turn into 0 or infinity.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hyalite {

// Lengths and coordinates [m]. The squared area of a parallelogram this large is 1e36: still a float.
inline constexpr double kLargestLength = 1e9;

// Radii, edges and distances [m]: their squares are normal floats (> 1.2e-38).
inline constexpr double kSmallestLength = 1e-9;

// Radiance, intensity and other strengths of light; times an area of 1e18 m^2 and pi it is still a float.
inline constexpr double kLargestEmission = 1e12;

// Two directions whose angle is below this [radians] are parallel: a float has 24 bits.
inline constexpr double kSmallestAngle = 1e-6;

// Image size: what image files and the film's 32-bit indices (one per channel and pixel) hold with room to spare.
inline constexpr std::uint32_t kLargestSide = 65536;
inline constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28U;

// Photons of one pass: photon indices have 24 bits.
inline constexpr std::uint32_t kMostPhotons = 1U << 24U;

// Sizes in bytes of a scene file, a GLSL file, a texture file and a mesh file; each is read into memory as a whole.
inline constexpr std::size_t kLargestSceneFile = std::size_t{64} << 20U;
inline constexpr std::size_t kLargestCodeFile = std::size_t{1} << 20U;
inline constexpr std::size_t kLargestTextureFile = std::size_t{1} << 30U;
inline constexpr std::size_t kLargestMeshFile = std::size_t{2} << 30U;

// Triangles of one mesh: a BVH leaf stores the index of its first triangle in 27 bits.
inline constexpr std::size_t kMostTriangles = std::size_t{1} << 27U;

// Pixels of one texture: a quarter of lavapipe's largest texel table; all textures of a scene share one table.
inline constexpr std::size_t kMostTexels = std::size_t{1} << 25U;

// Copies of one object by `repeat`: each takes about a kilobyte during upload to the device.
inline constexpr std::uint32_t kMostCopies = 1U << 22U;

// Nesting depth of lists and maps in a YAML file; a deeper tree could overflow the stack of a recursive reader. A csg
// of 32 shapes in which each list of two holds the next needs a depth of 70.
inline constexpr std::size_t kDeepestYaml = 128;

// Values in a YAML file with every alias (*name) expanded; otherwise nine nested aliases could expand to a billion.
inline constexpr std::size_t kMostYamlNodes = std::size_t{1} << 23U;

} // namespace hyalite
