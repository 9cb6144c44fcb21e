// Metal with complex index of refraction eta + i k.
#ifndef HYALITE_CONDUCTOR_GLSL
#define HYALITE_CONDUCTOR_GLSL
#include "bsdf/fresnel.glsl"
#include "bsdf/parts.glsl"

uint conductorFlags(MaterialRecord material) {
    return lobeFlag(material.roughness);
}

Lobe conductorLobe(MaterialRecord material, bool front) {
    return reflectingLobe(material, facetAlpha(material.roughness));
}

vec3 conductorReflectance(Lobe lobe, float cosine) {
    return fresnelConductor(cosine, lobe.material.eta, lobe.material.k);
}
#endif
