// A smooth surface that reflects `color` of the light at every angle.
#ifndef HYALITE_MIRROR_GLSL
#define HYALITE_MIRROR_GLSL
#include "bsdf/parts.glsl"

uint mirrorFlags(MaterialRecord material) {
    return kBsdfSpecular;
}

Lobe mirrorLobe(MaterialRecord material, bool front) {
    return reflectingLobe(material, 0.0);
}

vec3 mirrorReflectance(Lobe lobe, float cosine) {
    return lobe.material.color;
}
#endif
