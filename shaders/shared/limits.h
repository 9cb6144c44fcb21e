// Every fixed size in the program, each with its reason. The host checks them before work starts.
#ifndef HYALITE_SHARED_LIMITS_H
#define HYALITE_SHARED_LIMITS_H
#include "language.h"
SHARED_BEGIN

// Threads per workgroup: 8 to 64 measure alike on lavapipe, and 64 suits every GPU.
SHARED_CONSTANT kGroupSize = 64u;

// Groups in x of one dispatch when it needs more than one row; Vulkan guarantees 65 535.
SHARED_CONSTANT kGroupsPerRow = 32768u;

// Entries of a ray's traversal stack in one hierarchy: a hierarchy over ten million triangles may need 58. The builder
// computes what a tree needs and rebuilds it if that is more.
SHARED_CONSTANT kTraversalStack = 96u;

// Stack entries kept in variables: 4, 8 or 10 measure alike on lavapipe.
SHARED_CONSTANT kStackTops = 6u;

// Leaves of one CSG tree: their inside bits fill one word, and the program for 32 leaves fills one texel.
SHARED_CONSTANT kMaxCsgLeaves = 32u;

// Most photons per query: Jensen's pictures use 50 to 500, and a thread keeps 8 bytes for each.
SHARED_CONSTANT kMaxNearest = 512u;

// Entries of a photon query's traversal stack: at most one per level above the leaves, and 2^30 photons, as many as
// their numbers allow, make 30 levels.
SHARED_CONSTANT kKdStack = 32u;

// Longest path, in segments; a photon stores its length in 8 bits.
SHARED_CONSTANT kMaxDepth = 255u;

// Most lights whose visibility shadow photons may decide; the others get shadow rays.
SHARED_CONSTANT kMostClassifiedLights = 16u;

// Most lights in a scene for which camera paths test whether a direction out of smooth glass leads to one; with more
// lights, none is tested.
SHARED_CONSTANT kMostLightsSought = 16u;

// Marks "no object", "no light", "no material" in 32-bit indices.
SHARED_CONSTANT kNone = 0xffffffffu;

// Microfacets with alpha below this count as smooth: single precision could not resolve their directions. So does the
// boundary between media whose indices differ by less than a thousandth, which hardly refracts.
SHARED_FLOAT kSmoothAlpha = 1.0e-3F;
SHARED_FLOAT kSmoothIndex = 1.0e-3F;

// Least share of a pixel's paths that follow, at glass, the direction that leads to a light. If that direction carries
// F L and the other T l, the variance is least at F L / (F L + T l): more than a half for lights 25 times as bright as
// the radiance behind the glass. But the light may be occluded, and the highlight of a pane's back needs paths as well.
SHARED_FLOAT kShareToLight = 0.5F;

// Up to this many lights are compared one by one to pick one, without the tree (pick_light.glsl).
SHARED_CONSTANT kFewLights = 4u;

// Share of the picks of a light for a receiver that follow the lights' pmf, whatever the place: half of that is even
// over the lights, so N lights of any strength get 1 / (8 N) of the picks each.
SHARED_FLOAT kPicksByPmf = 0.25F;

// Of the other picks, the share that is even between light from beyond the scene and all other lights: the estimate
// that decides the rest knows nothing of occlusion. A sun that a roof keeps out takes at most 8 of 10 picks.
SHARED_FLOAT kEvenPicks = 0.5F;

// Share of the photons that are even over the lights, the rest being in proportion to their flux: the flux of light
// from beyond the scene grows with the scene, and says little of what it does where the camera looks.
SHARED_FLOAT kEvenPhotons = 0.5F;

// The least that a light is estimated to shine in a direction, of its intensity: the estimate is continuous, and a
// wrong bound cannot starve a light.
SHARED_FLOAT kLeastFade = 0.015625F;

// The least squared distance from a light that the estimate distinguishes [m^2].
SHARED_FLOAT kNearestLight2 = 1.0e-24F;

SHARED_END
#endif
