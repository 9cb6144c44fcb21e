// Glass: light that Fresnel's equations do not reflect is refracted.
#ifndef HYALITE_DIELECTRIC_GLSL
#define HYALITE_DIELECTRIC_GLSL
#include "bsdf/interface.glsl"
#include "bsdf/parts.glsl"

// Media of nearly equal index do not refract, however rough their boundary.
float dielectricAlpha(MaterialRecord material) {
    return abs(material.ior - 1.0) >= kSmoothIndex ? facetAlpha(material.roughness) : 0.0;
}

uint dielectricFlags(MaterialRecord material) {
    return kBsdfTransmitting | (dielectricAlpha(material) > 0.0 ? kBsdfGlossy : kBsdfSpecular);
}

Lobe dielectricLobe(MaterialRecord material, bool front) {
    if (isThin(material)) {
        return Lobe(material, 1.0, 0.0, true, false);
    }
    return Lobe(material, front ? 1.0 / material.ior : material.ior, dielectricAlpha(material), true, false);
}

vec3 dielectricReflectance(Lobe lobe, float cosine) {
    return vec3(meetLobe(lobe, cosine).reflectance);
}
#endif
