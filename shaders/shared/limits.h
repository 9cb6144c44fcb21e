// Every fixed size in the program, each with its reason. The host checks them before work starts.
#ifndef HYALITE_SHARED_LIMITS_H
#define HYALITE_SHARED_LIMITS_H
#include "language.h"
SHARED_BEGIN

// Threads of one workgroup: 8 to 64 measure alike on lavapipe, and 64 suits every GPU.
SHARED_CONSTANT kGroupSize = 64u;

// Groups in x of one dispatch when it needs more than one row; Vulkan guarantees 65 535.
SHARED_CONSTANT kGroupsPerRow = 32768u;

// Entries of a ray's traversal stack in one hierarchy: one over ten million triangles may need 58. The builder computes
// what a tree needs and makes another one if that is more.
SHARED_CONSTANT kTraversalStack = 96u;

// Those that stand in variables: 4, 8 or 10 measure alike on lavapipe.
SHARED_CONSTANT kStackTops = 6u;

// Leaves of one CSG tree: their inside bits are one word, and a program for so many fills one texel.
SHARED_CONSTANT kMaxCsgLeaves = 32u;

// Photons that one query may ask for: Jensen's pictures use 50 to 500, and a thread keeps 8 bytes for each.
SHARED_CONSTANT kMaxNearest = 512u;

// Entries of a photon query's traversal stack: at most one for every level above a leaf, and 2^30 photons, which their
// numbers leave room for, make 30 levels.
SHARED_CONSTANT kKdStack = 32u;

// Longest path, in segments; a photon stores its length in 8 bits.
SHARED_CONSTANT kMaxDepth = 255u;

// Lights whose visibility shadow photons may tell; the rest is asked by shadow rays.
SHARED_CONSTANT kMostClassifiedLights = 16u;

// Lights of a scene of which camera paths look whether a way out of smooth glass leads to them; none, where there are
// more.
SHARED_CONSTANT kMostLightsSought = 16u;

// Marks "no object", "no light", "no material" in 32-bit indices.
SHARED_CONSTANT kNone = 0xffffffffu;

// Microfacets of an alpha below this count as smooth: single precision could not tell their directions apart. So do
// those between media whose indices differ by less than a thousandth, which refract by nothing.
SHARED_FLOAT kSmoothAlpha = 1.0e-3F;
SHARED_FLOAT kSmoothIndex = 1.0e-3F;

// Share of a pixel's paths that take the one way at glass which leads to a light, at least. If that brings F L and the
// other way T l, the scatter is least at F L / (F L + T l): more than a half for lamps of 25 times what is seen through
// the glass; but the lamp may be hidden, and the highlight of a pane's back needs paths as well.
SHARED_FLOAT kShareToLight = 0.5F;

SHARED_END
#endif
