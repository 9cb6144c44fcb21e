// The two parts of a BSDF: a diffuse one, and a lobe of GGX microfacets [Walter07] or of a smooth surface. `wo` and
// `wi` are unit and point away from the surface, wo to the side that the normals are on.
#ifndef HYALITE_PARTS_GLSL
#define HYALITE_PARTS_GLSL
#include "shared/limits.h"
#include "shared/materials.h"
#include "bsdf/interface.glsl"
#include "bsdf/medium.glsl"
#include "lib/math.glsl"
#include "lib/specialization.glsl"

// How a surface reflects or refracts, seen from one side, without its diffuse part.
struct Lobe {
    MaterialRecord material; // with its textures multiplied in
    float eta;               // of a transmitting lobe: index of the wo side over that of the other
    float alpha;             // of the GGX distribution; 0: smooth
    bool transmits;
    bool isCoat; // lies over the material's other lobe
};

// The transported quantity: radiance is scaled by the squared indices at a boundary, flux is not.
const uint kRadiance = 0u; // along camera paths
const uint kFlux = 1u;     // along photon paths

struct BsdfSample {
    vec3 direction; // unit, away from the surface
    vec3 weight;    // BSDF times cosine over density; 0: absorbed
    float pdfW;     // density [1/sr]; 0: smooth, the direction is discrete
    bool through;   // to the side opposite wo
};

struct BsdfValue {
    vec3 fCos;         // BSDF times the cosine of wi [1/sr]
    float pdfW;        // density of sampling wi for wo [1/sr]
    float reversePdfW; // density of sampling wo for wi, from wi's side [1/sr]
};

const BsdfSample kAbsorbed = BsdfSample(vec3(0.0), vec3(0.0), 0.0, false);
const BsdfValue kNoValue = BsdfValue(vec3(0.0), 0.0, 0.0);

float meanComponent(vec3 v) {
    return (v.x + v.y + v.z) / 3.0;
}

// alpha of the GGX distribution; 0: smooth.
float facetAlpha(float roughness) {
    float alpha = roughness * roughness;
    return sceneHasRoughLobes() && alpha >= kSmoothAlpha ? alpha : 0.0;
}

uint lobeFlag(float roughness) {
    return facetAlpha(roughness) > 0.0 ? kBsdfGlossy : kBsdfSpecular;
}

// Fresnel's equations at a facet of a transmitting lobe. Thin glass: both faces at once and all reflections between them,
// 2 R / (1 + R), and what is transmitted goes straight on.
Interface meetLobe(Lobe lobe, float cosIncident) {
    if (isThin(lobe.material)) {
        float R = meetInterface(cosIncident, 1.0 / lobe.material.ior).reflectance;
        return Interface(2.0 * R / (1.0 + R), cosIncident, 1.0);
    }
    return meetInterface(cosIncident, lobe.eta);
}

// The lobe of a surface that does not transmit.
Lobe reflectingLobe(MaterialRecord material, float alpha) {
    return Lobe(material, 1.0, alpha, false, false);
}
#endif
