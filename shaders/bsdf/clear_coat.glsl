// A clear coat over metallic-roughness, after glTF's KHR_materials_clearcoat: a colourless dielectric film covers the
// share `coat` of the surface and reflects F by Fresnel's equations, with facets of its own roughness. The light that
// it does not reflect on the way in reaches the base, and light from the base leaves with the same transmittance:
//     f = coat F D G / (4 cosOut cosIn) + T(cosOut) T(cosIn) f_base,  T = 1 - coat F
// The specification attenuates the base by the view direction alone, which is not reciprocal. With both factors f is
// reciprocal; and since the base reflects no more than it receives, at most coat F + T <= 1 leaves a surface under a
// smooth coat, at any view angle. A coat of index 1 has F = 0 and T = 1: the bare base. Light reflected back between
// coat and base is lost, and refraction in the coat is ignored: the base sees the directions outside.
#ifndef HYALITE_CLEAR_COAT_GLSL
#define HYALITE_CLEAR_COAT_GLSL
#include "bsdf/interface.glsl"
#include "bsdf/metallic_roughness.glsl"
#include "bsdf/parts.glsl"

// Number of midpoints in the squared cosine, in which uniform incident light is uniformly distributed.
const uint kCoatParts = 32u;

// Share of the light that a facet of the coat reflects.
float coatReflected(MaterialRecord material, float cosine) {
    return material.coat * meetInterface(clamp(cosine, 0.0, 1.0), 1.0 / material.coatIor).reflectance;
}

uint clearCoatFlags(MaterialRecord material) {
    return metallicRoughnessFlags(material) | lobeFlag(material.coatRoughness);
}

vec3 clearCoatAlbedo(MaterialRecord material) {
    return metallicRoughnessAlbedo(material);
}

float clearCoatOverLobe(MaterialRecord material, float cosine) {
    return 1.0 - coatReflected(material, cosine);
}

float clearCoatOverDiffuse(MaterialRecord material, float cosine) {
    return clearCoatOverLobe(material, cosine) * metallicRoughnessOverDiffuse(material, cosine);
}

float clearCoatMeanOverDiffuse(MaterialRecord material) {
    float sum = 0.0;
    for (uint i = 0u; i < kCoatParts; ++i) {
        sum += clearCoatOverDiffuse(material, sqrt((float(i) + 0.5) / float(kCoatParts)));
    }
    return sum / float(kCoatParts);
}

Lobe clearCoatLobe(MaterialRecord material, bool front) {
    return metallicRoughnessLobe(material, front);
}

Lobe clearCoatCoat(MaterialRecord material) {
    Lobe coat = reflectingLobe(material, facetAlpha(material.coatRoughness));
    coat.isCoat = true;
    return coat;
}

vec3 clearCoatReflectance(Lobe lobe, float cosine) {
    return lobe.isCoat ? vec3(coatReflected(lobe.material, cosine)) : metallicRoughnessReflectance(lobe, cosine);
}
#endif
