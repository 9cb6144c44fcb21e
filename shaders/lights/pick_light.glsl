// Picks a light for a receiver by what it may do there, through a hierarchy over the lights [ContyEstevez18]: the
// irradiance that each may bring, without occlusion. A part of the picks is by the lights' pmf instead, and of the rest
// a part is even between the lights of the hierarchy and those beside it: no light can vanish beside a stronger one that
// is occluded.
#ifndef HYALITE_PICK_LIGHT_GLSL
#define HYALITE_PICK_LIGHT_GLSL
#include "shared/scene_records.h"
#include "lib/math.glsl"
#include "lib/specialization.glsl"

struct LightPick {
    uint light;
    float pmf; // probability of the pick at its receiver
};

// The first light whose cdf exceeds x in [0, 1): light i with probability pmf_i.
uint pickLight(LightArray lights, uint lightCount, float x) {
    uint first = 0u, last = lightCount - 1u;
    while (first < last) {
        uint middle = (first + last) / 2u;
        if (x < lights.at[middle].cdf) {
            last = middle;
        } else {
            first = middle + 1u;
        }
    }
    return first;
}

// (cos, sin) of the angle a - b, or of 0 if b is larger; both angles in [0, pi], given likewise.
vec2 angleBeyond(vec2 a, vec2 b) {
    return a.x >= b.x ? vec2(1.0, 0.0) : vec2(a.x * b.x + a.y * b.y, a.y * b.x - a.x * b.y);
}

// Estimate of the irradiance from the node's lights on a surface at x that faces them [1/m^2, times an unknown unit].
float treeImportance(LightNode node, vec3 x) {
    vec3 way = x - node.center;
    float distance2 = dot(way, way);
    float radius2 = node.radius * node.radius;
    float fade = 1.0;
    if (distance2 > radius2) {
        float distance = sqrt(distance2);
        vec2 off = vec2(dot(node.axis, way), length(cross(node.axis, way))) / distance;
        off = angleBeyond(off, vec2(node.cosSpread, node.sinSpread));
        float sine = node.radius / distance; // of the angle under which the node's sphere is seen
        off = angleBeyond(off, vec2(sqrt(1.0 - sine * sine), sine));
        fade = max(kLeastFade, (off.x - node.cosFade) / (1.0 - node.cosFade));
    }
    return node.intensity * fade / max(max(distance2, radius2), kNearestLight2);
}

// The same for a light beside the tree.
float farImportance(LightNode node, vec3 x) {
    if (node.radius == 0.0) {
        return node.intensity;
    }
    vec3 way = x - node.center; // from a beam's start: a beam fades around its axis
    vec3 across = way - dot(way, node.axis) * node.axis;
    float radius2 = node.radius * node.radius;
    return node.intensity * radius2 / max(radius2, dot(across, across));
}

float farImportance(LightHierarchy all, vec3 x) {
    float sum = 0.0;
    for (uint i = 0u; i < all.farCount; ++i) {
        sum += farImportance(all.nodes.at[i], x);
    }
    return max(sum, kTiny);
}

// Probability that a pick that is not by pmf takes a far light, if there are lights of both kinds; `far`, `near`: their
// importance.
float farShare(float far, float near) {
    return 0.5 * kEvenPicks + (1.0 - kEvenPicks) * far / (far + near);
}

float farShare(LightHierarchy all, float far, vec3 x) {
    if (all.farCount == 0u || all.farCount == all.lightCount) {
        return all.farCount == 0u ? 0.0 : 1.0;
    }
    return farShare(far, treeImportance(all.nodes.at[all.farCount], x));
}

// Of two sibling nodes, the probability to descend to the first.
float firstShare(LightHierarchy all, uint first, uint second, vec3 x) {
    float a = treeImportance(all.nodes.at[first], x) + kTiny; // even if both underflow
    return a / (a + treeImportance(all.nodes.at[second], x) + kTiny);
}

// Descends to a light by importance; u in [0, 1).
LightPick pickInTree(LightHierarchy all, vec3 x, float u) {
    uint node = all.farCount;
    float probability = 1.0;
    uint second = all.nodes.at[node].second;
    while (second != 0u) {
        float share = firstShare(all, node + 1u, second, x);
        bool isFirst = u < share;
        u = isFirst ? u / share : (u - share) / (1.0 - share);
        probability *= isFirst ? share : 1.0 - share;
        node = isFirst ? node + 1u : second;
        second = all.nodes.at[node].second;
    }
    return LightPick(all.nodes.at[node].light, probability);
}

// Probability that pickInTree ends at the leaf.
float probabilityInTree(LightHierarchy all, uint leaf, vec3 x) {
    float probability = 1.0;
    uint parent = all.nodes.at[leaf].parent;
    while (parent != kNone) {
        uint second = all.nodes.at[parent].second;
        float share = firstShare(all, parent + 1u, second, x);
        probability *= leaf == second ? 1.0 - share : share;
        leaf = parent;
        parent = all.nodes.at[leaf].parent;
    }
    return probability;
}

LightPick pickFar(LightHierarchy all, float far, vec3 x, float u) {
    float sum = 0.0;
    float importance = 0.0;
    uint node = 0u;
    for (uint i = 0u; i < all.farCount; ++i) {
        importance = farImportance(all.nodes.at[i], x);
        node = i;
        sum += importance;
        if (u * far < sum) {
            break;
        }
    }
    return LightPick(all.nodes.at[node].light, importance / far);
}

// ---- Few lights: their number is a constant, so no loop and no tree is left, and every thread loads the same records.

bool areFew() {
    return kLightCount <= kFewLights;
}

bool isFar(LightArray lights, uint i) {
    return i < kLightCount && lights.at[i].isFar != 0u;
}

bool isNear(LightArray lights, uint i) {
    return i < kLightCount && lights.at[i].isFar == 0u;
}

float ownImportance(LightArray lights, uint i, vec3 x) {
    if (i >= kLightCount) {
        return 0.0;
    }
    return isFar(lights, i) ? farImportance(lights.at[i].extent, x) : treeImportance(lights.at[i].extent, x);
}

float pmfOf(LightArray lights, uint i) {
    return i < kLightCount ? lights.at[i].pmf : 0.0;
}

// The probabilities of up to kFewLights lights for a receiver at x.
vec4 probabilitiesOfFew(LightArray lights, vec3 x) {
    vec4 own = vec4(ownImportance(lights, 0u, x), ownImportance(lights, 1u, x), ownImportance(lights, 2u, x),
                    ownImportance(lights, 3u, x));
    bvec4 far = bvec4(isFar(lights, 0u), isFar(lights, 1u), isFar(lights, 2u), isFar(lights, 3u));
    bvec4 near = bvec4(isNear(lights, 0u), isNear(lights, 1u), isNear(lights, 2u), isNear(lights, 3u));
    float farSum = max(dot(own, vec4(far)), kTiny);
    float nearSum = max(dot(own, vec4(near)), kTiny);
    float share = any(far) ? any(near) ? farShare(farSum, nearSum) : 1.0 : 0.0;
    vec4 byPlace = own * mix(vec4((1.0 - share) / nearSum), vec4(share / farSum), far);
    vec4 pmf = vec4(pmfOf(lights, 0u), pmfOf(lights, 1u), pmfOf(lights, 2u), pmfOf(lights, 3u));
    return kPicksByPmf * pmf + (1.0 - kPicksByPmf) * byPlace;
}

LightPick pickAmongFew(LightArray lights, vec3 x, float u) {
    vec4 p = probabilitiesOfFew(lights, x);
    uint i = u < p.x ? 0u : u < p.x + p.y ? 1u : u < p.x + p.y + p.z ? 2u : 3u;
    i = min(i, kLightCount - 1u);
    return LightPick(i, i < 2u ? (i == 0u ? p.x : p.y) : (i == 2u ? p.z : p.w));
}

// ---- Any number of lights

// Picks a light for a receiver at x; u uniform in [0, 1)^2.
LightPick pickLightAt(LightArray lights, vec3 x, vec2 u) {
    if (kLightCount == 1u) {
        return LightPick(0u, 1.0);
    }
    if (areFew()) {
        return pickAmongFew(lights, x, u.x);
    }
    LightHierarchy all = lights.at[0].hierarchy.at[0];
    float far = farImportance(all, x);
    float share = farShare(all, far, x);
    LightPick pick;
    float group = (u.y - kPicksByPmf) / (1.0 - kPicksByPmf);
    if (group < 0.0) {
        pick.light = pickLight(lights, all.lightCount, u.x);
        uint node = lights.at[pick.light].node;
        pick.pmf = node < all.farCount ? share * farImportance(all.nodes.at[node], x) / far
                                       : (1.0 - share) * probabilityInTree(all, node, x);
    } else if (group < share) {
        pick = pickFar(all, far, x, u.x);
        pick.pmf *= share;
    } else {
        pick = pickInTree(all, x, u.x);
        pick.pmf *= 1.0 - share;
    }
    pick.pmf = kPicksByPmf * lights.at[pick.light].pmf + (1.0 - kPicksByPmf) * pick.pmf;
    return pick;
}

// Probability that pickLightAt picks the light for a receiver at x.
float pickProbability(LightArray lights, uint index, vec3 x) {
    if (kLightCount == 1u) {
        return 1.0;
    }
    if (areFew()) {
        vec4 p = probabilitiesOfFew(lights, x);
        return index < 2u ? (index == 0u ? p.x : p.y) : (index == 2u ? p.z : p.w);
    }
    LightRecord light = lights.at[index];
    LightHierarchy all = light.hierarchy.at[0];
    float far = farImportance(all, x);
    float share = farShare(all, far, x);
    float byPlace = light.node < all.farCount ? share * farImportance(all.nodes.at[light.node], x) / far
                                              : (1.0 - share) * probabilityInTree(all, light.node, x);
    return kPicksByPmf * light.pmf + (1.0 - kPicksByPmf) * byPlace;
}
#endif
