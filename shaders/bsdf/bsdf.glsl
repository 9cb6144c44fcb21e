// The BSDF of a material: a diffuse part, a lobe that reflects and perhaps transmits, or both. The contract of a model,
// which is a file of this folder and a row of shared/materials.h:
//   NAMEFlags            its kBsdf… flags
//   NAMEAlbedo           diffuse part: share of the light reflected, without the layer over it
//   NAMEOverDiffuse      transmittance of the layer over the diffuse part at an angle, NAMEMeanOverDiffuse its mean over the
//                        cosine-weighted hemisphere
//   NAMELobe             the lobe that reflects or refracts, seen from one side
//   NAMEReflectance      reflectance of a facet of the lobe
//   NAMECoat             a second lobe over everything else; NAMEOverLobe its transmittance to the lobe at an angle
// Sampling, evaluation and densities follow from these here and in microfacets.glsl.
#ifndef HYALITE_BSDF_GLSL
#define HYALITE_BSDF_GLSL
#include "shared/limits.h"
#include "bsdf/microfacets.glsl"
#include "bsdf/parts.glsl"
#include "lib/sampling.glsl"
#include "lib/specialization.glsl"

#define HYALITE_BSDF_MODELS
#include "shared/materials.h"
#undef HYALITE_BSDF_MODELS

// ---- The dispatch

uint bsdfFlags(MaterialRecord material) {
#define ROW(Name, name)                                                                                                \
    if (isMaterial(material.type, kMaterial##Name)) {                                                                  \
        return name##Flags(material);                                                                                  \
    }
    HYALITE_MODELS(ROW)
#undef ROW
    return 0u;
}

vec3 diffuseShare(MaterialRecord material) {
#define ROW(Name, name)                                                                                                \
    if (isMaterial(material.type, kMaterial##Name)) {                                                                  \
        return name##Albedo(material);                                                                                 \
    }
    HYALITE_DIFFUSE_MODELS(ROW)
#undef ROW
    return vec3(0.0);
}

float overDiffuse(MaterialRecord material, float cosine) {
#define ROW(Name, name)                                                                                                \
    if (isMaterial(material.type, kMaterial##Name)) {                                                                  \
        return name##OverDiffuse(material, cosine);                                                                    \
    }
    HYALITE_DIFFUSE_MODELS(ROW)
#undef ROW
    return 1.0;
}

float meanOverDiffuse(MaterialRecord material) {
#define ROW(Name, name)                                                                                                \
    if (isMaterial(material.type, kMaterial##Name)) {                                                                  \
        return name##MeanOverDiffuse(material);                                                                        \
    }
    HYALITE_DIFFUSE_MODELS(ROW)
#undef ROW
    return 1.0;
}

// The lobe of the material seen from one side; `front` as in Surface.
Lobe lobeOf(MaterialRecord material, bool front) {
#define ROW(Name, name)                                                                                                \
    if (isMaterial(material.type, kMaterial##Name)) {                                                                  \
        return name##Lobe(material, front);                                                                            \
    }
    HYALITE_LOBE_MODELS(ROW)
#undef ROW
    return reflectingLobe(material, 0.0);
}

// Share of the light that a facet reflects.
vec3 lobeReflectance(Lobe lobe, float cosine) {
#define ROW(Name, name)                                                                                                \
    if (isMaterial(lobe.material.type, kMaterial##Name)) {                                                             \
        return name##Reflectance(lobe, cosine);                                                                        \
    }
    HYALITE_LOBE_MODELS(ROW)
#undef ROW
    return vec3(0.0);
}

bool isCoated(MaterialRecord material) {
#define ROW(Name, name) || isMaterial(material.type, kMaterial##Name)
    return false HYALITE_COATED_MODELS(ROW);
#undef ROW
}

// The coat of a coated material.
Lobe coatOf(MaterialRecord material) {
#define ROW(Name, name)                                                                                                \
    if (isMaterial(material.type, kMaterial##Name)) {                                                                  \
        return name##Coat(material);                                                                                   \
    }
    HYALITE_COATED_MODELS(ROW)
#undef ROW
    return reflectingLobe(material, 0.0);
}

// Transmittance, at an angle, of the layer over the lobe.
float overLobe(Lobe lobe, float cosine) {
    if (lobe.isCoat) {
        return 1.0;
    }
#define ROW(Name, name)                                                                                                \
    if (isMaterial(lobe.material.type, kMaterial##Name)) {                                                             \
        return name##OverLobe(lobe.material, cosine);                                                                  \
    }
    HYALITE_COATED_MODELS(ROW)
#undef ROW
    return 1.0;
}

// ---- Derived from the models

bool hasDiffusePart(MaterialRecord material) {
    return (bsdfFlags(material) & kBsdfDiffuse) != 0u;
}

bool hasLobe(MaterialRecord material) {
    return (bsdfFlags(material) & (kBsdfGlossy | kBsdfSpecular)) != 0u;
}

// Smooth glass: a path is reflected or refracted; no other direction is possible.
bool isSmoothGlass(Lobe lobe) {
    return lobe.transmits && lobe.alpha == 0.0;
}

// Share of the light that a lobe reflects, averaged over the channels.
float lobeShare(Lobe lobe, float cosOut) {
    return meanComponent(lobeReflectance(lobe, cosOut)) * overLobe(lobe, cosOut);
}

// Probability of sampling the coat, given that the path takes a lobe.
float coatProbability(Lobe lobe, float cosOut) {
    if (!isCoated(lobe.material)) {
        return 0.0;
    }
    float ofCoat = lobeShare(coatOf(lobe.material), cosOut);
    return ofCoat / max(ofCoat + lobeShare(lobe, cosOut), kTiny);
}

// Picks the lobe that a path takes: `lobe` or the coat over it. `choice` in [0, 1); `probability` is that of the
// result.
Lobe pickLobe(Lobe lobe, float cosOut, float choice, out float probability) {
    probability = 1.0;
    if (!isCoated(lobe.material)) {
        return lobe;
    }
    float ofCoat = coatProbability(lobe, cosOut);
    if (choice < ofCoat) {
        probability = ofCoat;
        return coatOf(lobe.material);
    }
    probability = 1.0 - ofCoat;
    return lobe;
}

// Probability of sampling a lobe rather than the diffuse part.
float lobeProbability(MaterialRecord material, Lobe lobe, float cosOut) {
    if (!hasDiffusePart(material)) {
        return 1.0;
    }
    if (!hasLobe(material)) {
        return 0.0;
    }
    float reflected_ = lobeShare(lobe, cosOut);
    if (isCoated(material)) {
        reflected_ += lobeShare(coatOf(material), cosOut);
    }
    return reflected_ / (reflected_ + meanComponent(diffuseShare(material)) * overDiffuse(material, cosOut));
}

// Share of the light that leaves the surface again; rough lobes lose some of it.
vec3 leavingShare(MaterialRecord material, Lobe lobe, float cosOut) {
    vec3 diffuse = diffuseShare(material) * (overDiffuse(material, cosOut) * meanOverDiffuse(material));
    if (!hasLobe(material)) {
        return diffuse;
    }
    if (isCoated(material)) {
        diffuse += lobeReflectance(coatOf(material), cosOut);
    }
    float over = overLobe(lobe, cosOut);
    return (lobe.transmits ? vec3(1.0) : lobeReflectance(lobe, cosOut) * (over * over)) + diffuse;
}

// Samples the diffuse part by the cosine, for paths that take it with this probability. Directions below the geometric
// surface, which a smoothed normal may cause, are not absorbed.
BsdfSample sampleDiffuse(MaterialRecord material, vec3 normal, float cosOut, vec2 u, float probability) {
    BsdfSample s;
    s.direction = cosineHemisphere(u, normal);
    float cosine = dot(s.direction, normal);
    s.weight = diffuseShare(material) * (overDiffuse(material, cosOut) * overDiffuse(material, cosine) / probability);
    s.pdfW = probability * cosine * kInvPi;
    s.through = false;
    return s;
}

BsdfValue evaluateDiffuse(MaterialRecord material, vec3 normal, vec3 wo, vec3 wi) {
    float cosOut = dot(wo, normal);
    float cosine = dot(wi, normal);
    if (cosOut <= 0.0 || cosine <= 0.0) {
        return kNoValue;
    }
    vec3 albedo = diffuseShare(material) * (overDiffuse(material, cosOut) * overDiffuse(material, cosine));
    return BsdfValue(albedo * (kInvPi * cosine), cosine * kInvPi, cosOut * kInvPi);
}

// Sampling and evaluation of the whole BSDF: a path takes one of the parts; evaluation sums all of them for a pair of
// directions. A smooth lobe has neither value nor density.
BsdfSample sampleBsdf(MaterialRecord material, bool front, vec3 normal, vec3 geometricNormal, vec3 wo, vec2 u,
                      float choice, uint transport) {
    Lobe lobe = lobeOf(material, front);
    float cosOut = clamp(dot(wo, normal), 0.0, 1.0);
    float probability = bsdfFlags(material) == 0u ? 0.0 : lobeProbability(material, lobe, cosOut);
    if (choice >= probability) {
        return sampleDiffuse(material, normal, cosOut, u, 1.0 - probability);
    }
    float ofLobe;
    lobe = pickLobe(lobe, cosOut, choice / probability, ofLobe);
    probability *= ofLobe;
    BsdfSample s = sampleLobe(lobe, normal, geometricNormal, wo, u, choice / probability, transport);
    s.weight /= probability;
    s.pdfW *= probability;
    return s;
}

BsdfValue evaluateBsdf(MaterialRecord material, bool front, vec3 normal, vec3 geometricNormal, vec3 wo, vec3 wi,
                       uint transport) {
    Lobe lobe = lobeOf(material, front);
    float cosOut = clamp(dot(wo, normal), 0.0, 1.0);
    float cosIn = clamp(dot(wi, normal), 0.0, 1.0);
    BsdfValue value = kNoValue;
    if (hasDiffusePart(material)) {
        BsdfValue diffuse = evaluateDiffuse(material, normal, wo, wi);
        value.fCos = diffuse.fCos;
        value.pdfW = (1.0 - lobeProbability(material, lobe, cosOut)) * diffuse.pdfW;
        value.reversePdfW = (1.0 - lobeProbability(material, lobe, cosIn)) * diffuse.reversePdfW;
    }
    float ofCoat = coatProbability(lobe, cosOut);
    float reverseOfCoat = coatProbability(lobe, cosIn);
    for (uint i = 0u; i < (isCoated(material) ? 2u : 1u); ++i) {
        Lobe one = i == 0u ? lobe : coatOf(material);
        if (one.alpha > 0.0) {
            BsdfValue rough = evaluateLobe(one, normal, geometricNormal, wo, wi, transport);
            value.fCos += rough.fCos;
            value.pdfW += lobeProbability(material, lobe, cosOut) * (i == 0u ? 1.0 - ofCoat : ofCoat) * rough.pdfW;
            value.reversePdfW += lobeProbability(material, lobe, cosIn) *
                                 (i == 0u ? 1.0 - reverseOfCoat : reverseOfCoat) * rough.reversePdfW;
        }
    }
    return value;
}
#endif
