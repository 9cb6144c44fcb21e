// What the scene holds, known when a kernel is compiled for it: what it does not hold costs nothing.
#ifndef HYALITE_SPECIALIZATION_GLSL
#define HYALITE_SPECIALIZATION_GLSL
#include "shared/limits.h"
#include "shared/scene_records.h"

// Bit kShape… is set for every type of shape in the scene, leaves of CSG included.
layout(constant_id = 0) const uint kShapeTypes = 0xffffffffu;
// A scene of so few objects that trying each is faster than a hierarchy over them; 0: it has more.
layout(constant_id = 1) const uint kFewObjects = 0u;
// The first objects of the table that have no end and stand outside the hierarchy.
layout(constant_id = 2) const uint kEndlessObjects = 0u;
// Bit kMaterial… is set for every type of material in the scene, kMaterialRough too where any is rough.
layout(constant_id = 3) const uint kMaterialTypes = 0xffffffffu;

// 0: no material has a texture.
layout(constant_id = 4) const uint kTextures = 1u;

// 1: camera paths go on from diffuse surfaces, where lights were sampled for them. (5, 6: see nearest.glsl)
layout(constant_id = 7) const uint kDiffuseBounces = 0u;

// Lights of which glass looks whether a way leads to them: all of the table, or none where it is long.
layout(constant_id = 8) const uint kLightsSought = 0u;

// What a ray may have on its stack at most (stack.glsl). Lavapipe fills a thread's arrays with zeros before it begins: so
// they are no larger than the scene needs.
layout(constant_id = 9) const uint kStackEntries = 2u * kTraversalStack;

// The most leaves that a solid of the scene has, at least 1.
layout(constant_id = 10) const uint kCsgLeaves = kMaxCsgLeaves;

// Bit kLight… is set for every type of light in the scene. Of one type alone, none is asked for its type.
layout(constant_id = 11) const uint kLightTypes = 0xffffffffu;

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

bool isLight(uint type, uint light) {
    return ((kLightTypes >> light) & 1u) != 0u && (kLightTypes == 1u << light || type == light);
}
#endif
