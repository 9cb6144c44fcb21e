// A surface whose reflectance, smooth or at microfacets, is a function that the scene supplies.
#ifndef HYALITE_CUSTOM_GLSL
#define HYALITE_CUSTOM_GLSL
#include "bsdf/custom_reflectance.glsl"
#include "bsdf/parts.glsl"

uint customFlags(MaterialRecord material) {
    return lobeFlag(material.roughness);
}

Lobe customLobe(MaterialRecord material, bool front) {
    return reflectingLobe(material, facetAlpha(material.roughness));
}

vec3 customReflectance(Lobe lobe, float cosine) {
    return clamp(customReflectance(lobe.material.function, cosine, lobe.material.parameters), 0.0, 1.0);
}
#endif
