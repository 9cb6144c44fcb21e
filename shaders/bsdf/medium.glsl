// The media around paths: which one a path is in, its index, and absorption in it. Overlapping dielectrics with
// priorities follow [SchmidtBudge02]; without a priority a dielectric is nested in whatever a path enters it from.
#ifndef HYALITE_MEDIUM_GLSL
#define HYALITE_MEDIUM_GLSL
#include "shared/limits.h"
#include "shared/media.h"
#include "shared/scene_records.h"
#include "lib/math.glsl"
#include "lib/specialization.glsl"

struct Medium {
    uint material; // kNone: none
    float ior;     // over that of vacuum
};

// The medium of a list. From the outermost on: a dielectric without priority replaces the medium found so far and
// multiplies its index; one with a priority replaces media of lower and, in the order of the materials, equal priority.
Medium mediumOf(MaterialArray materials, uint media) {
    Medium medium = Medium(kNone, 1.0);
    uint priority = 0u;
    uint holder = 0u; // the material that has this priority
    for (uint place = mediaCapacity(kMediumBits); place > 0u; --place) {
        uint entry = mediumAt(media, place - 1u, kMediumBits);
        if (entry == kNone) {
            continue;
        }
        uint own = materials.at[entry].priority;
        if (own == 0u) {
            medium = Medium(entry, medium.ior * materials.at[entry].ior);
        } else if (own > priority || (own == priority && entry >= holder)) {
            medium = Medium(entry, materials.at[entry].ior);
            priority = own;
            holder = entry;
        }
    }
    return medium;
}

// The material of the medium of a list; kNone: none.
uint mediumMaterial(MaterialArray materials, uint media) {
    return mediaNeed(kMediaIndices) ? mediumOf(materials, media).material : mediumAt(media, 0u, kMediumBits);
}

// Share of the light left after a distance [m] in the medium of a list: e^(-sigma t), the Beer-Lambert law.
vec3 transmittance(MaterialArray materials, uint media, float distance) {
    if (!mediaNeed(kMediaAbsorb) || media == kNoMedia) {
        return vec3(1.0);
    }
    uint medium = mediumMaterial(materials, media);
    if (medium == kNone) {
        return vec3(1.0);
    }
    vec3 depth = materials.at[medium].absorption * distance;
    return vec3(exponential(-depth.x), exponential(-depth.y), exponential(-depth.z));
}

bool isThin(MaterialRecord material) {
    return mediaNeed(kMediaThin) && material.thin != 0u;
}

// The media behind a surface of the material with this number; `front`: the path arrives at its front, and would enter.
uint mediaBehind(MaterialRecord material, uint number, bool front, uint media) {
    if (!isMaterial(material.type, kMaterialDielectric) || isThin(material)) {
        return media;
    }
    return front ? enterMedium(media, number, kMediumBits) : leaveMedium(media, number, kMediumBits);
}

// The material with indices relative to the medium that the path arrives in: `media` there, `beyond` on the other side.
// Only dielectrics and metals have an index of their own.
MaterialRecord amongMedia(MaterialArray materials, MaterialRecord material, bool front, uint media, uint beyond) {
    if (mediaNeed(kMediaMetals) && isMaterial(material.type, kMaterialConductor) && media != kNoMedia) {
        float around = mediumOf(materials, media).ior;
        material.eta /= around;
        material.k /= around;
    }
    if (mediaNeed(kMediaIndices) && isMaterial(material.type, kMaterialDielectric) && !isThin(material)) {
        float around = mediumOf(materials, media).ior;
        float behind = mediumOf(materials, beyond).ior;
        material.ior = front ? behind / around : around / behind;
    }
    return material;
}
#endif
