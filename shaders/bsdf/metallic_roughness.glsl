// glTF's model: a metal, a diffuse base under a dielectric coat, or a mixture of the two. The coat is [Shirley97a]'s:
// the light that it does not reflect on the way in and out reaches the base.
#ifndef HYALITE_METALLIC_ROUGHNESS_GLSL
#define HYALITE_METALLIC_ROUGHNESS_GLSL
#include "bsdf/fresnel.glsl"
#include "bsdf/parts.glsl"

// Normalises by the mean of metallicRoughnessOverDiffuse over the cosine-weighted hemisphere, 20/21.
const float kCoatNormalization = 21.0 / 20.0;

vec3 reflectedAtNormal(MaterialRecord material) {
    return mix(vec3(0.04), material.color, material.metallic);
}

uint metallicRoughnessFlags(MaterialRecord material) {
    bool hasBase = (1.0 - material.metallic) * maxComponent(material.color) > 0.0;
    return lobeFlag(material.roughness) | (hasBase ? kBsdfDiffuse | kBsdfLayered : 0u);
}

vec3 metallicRoughnessAlbedo(MaterialRecord material) {
    vec3 entering = (1.0 - material.metallic) * (1.0 - reflectedAtNormal(material));
    return kCoatNormalization * entering * material.color;
}

// Transmittance of the coat at the angle, relative to 1 - F0. With F0 at normal incidence Schlick's approximation
// reflects 1 - (1 - F0) times this.
float metallicRoughnessOverDiffuse(MaterialRecord material, float cosine) {
    return 1.0 - schlickPower(cosine);
}

// The integral of 2 c (1 - c)^5 over c in [0, 1] is 1/21.
float metallicRoughnessMeanOverDiffuse(MaterialRecord material) {
    return 1.0 - 1.0 / 21.0;
}

Lobe metallicRoughnessLobe(MaterialRecord material, bool front) {
    return reflectingLobe(material, facetAlpha(material.roughness));
}

vec3 metallicRoughnessReflectance(Lobe lobe, float cosine) {
    vec3 atNormal = reflectedAtNormal(lobe.material);
    return atNormal + (1.0 - atNormal) * schlickPower(cosine);
}
#endif
