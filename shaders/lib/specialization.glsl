// Constants that describe the scene when a kernel is compiled for it: features that the scene lacks cost nothing.
#ifndef HYALITE_SPECIALIZATION_GLSL
#define HYALITE_SPECIALIZATION_GLSL
#include "shared/limits.h"
#include "shared/media.h"
#include "shared/scene_records.h"

// Bit kShape… is set for every type of shape in the scene, leaves of CSG included.
layout(constant_id = 0) const uint kShapeTypes = 0xffffffffu;
// Number of objects if they are so few that testing each is faster than a hierarchy over them; else 0.
layout(constant_id = 1) const uint kFewObjects = 0u;
// Number of unbounded objects: they come first in the table and stay outside the hierarchy.
layout(constant_id = 2) const uint kEndlessObjects = 0u;
// Bit kMaterial… is set for every type of material in the scene, kMaterialRough too if any is rough.
layout(constant_id = 3) const uint kMaterialTypes = 0xffffffffu;

// 0: no material has a texture.
layout(constant_id = 4) const uint kTextures = 1u;

// 1: camera paths continue from diffuse surfaces where lights were sampled. (5, 6: see nearest.glsl)
layout(constant_id = 7) const uint kDiffuseBounces = 0u;

// Number of lights that smooth glass tests its two directions against: the whole table, or 0 if it is long.
layout(constant_id = 8) const uint kLightsSought = 0u;

// Most entries on a ray's stack (stack.glsl). Lavapipe zeroes a thread's arrays before it begins, so they are no larger
// than the scene needs.
layout(constant_id = 9) const uint kStackEntries = 2u * kTraversalStack;

// Most leaves of any CSG solid in the scene, at least 1.
layout(constant_id = 10) const uint kCsgLeaves = kMaxCsgLeaves;

// Bit kLight… is set for every type of light in the scene. With a single type, no light is asked for its type.
layout(constant_id = 11) const uint kLightTypes = 0xffffffffu;

// Number of lights, at most kFewLights + 1, which stands for any larger number.
layout(constant_id = 12) const uint kLightCount = kFewLights + 1u;

// Bits of an entry in a list of media (media.h).
layout(constant_id = 13) const uint kMediumBits = 8u;

// kMedia… bits: what the dielectrics of the scene need.
layout(constant_id = 14) const uint kMediaNeeds = 0xffffffffu;

bool sceneHas(uint shape) {
    return ((kShapeTypes >> shape) & 1u) != 0u;
}

bool isShape(uint type, uint shape) {
    return sceneHas(shape) && (type & kShapeTypeMask) == shape;
}

bool sceneHasRoughLobes() {
    return ((kMaterialTypes >> kMaterialRough) & 1u) != 0u;
}

bool isMaterial(uint type, uint material) {
    return ((kMaterialTypes >> material) & 1u) != 0u && type == material;
}

bool mediaNeed(uint what) {
    return (kMediaNeeds & what) != 0u;
}

bool isLight(uint type, uint light) {
    return ((kLightTypes >> light) & 1u) != 0u && (kLightTypes == 1u << light || type == light);
}
#endif
