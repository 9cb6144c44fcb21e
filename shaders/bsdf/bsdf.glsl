// What the surface of a material does with light: a diffuse part, a lobe that reflects and perhaps transmits, or both.
// Lobes are smooth, then they have no density, or rough by GGX microfacets [Walter07]. `wo` and `wi` are unit and point
// away from the surface, wo to the side that Surface.normal is on. Rough lobes let each ray meet one facet only: what
// would be reflected from facet to facet is lost, more the rougher they are.
#ifndef HYALITE_BSDF_GLSL
#define HYALITE_BSDF_GLSL
#include "shared/limits.h"
#include "shared/path_records.h"
#include "bsdf/custom_reflectance.glsl"
#include "bsdf/dielectric.glsl"
#include "bsdf/diffuse.glsl"
#include "bsdf/ggx.glsl"
#include "lib/specialization.glsl"

struct DiffusePart {
    vec3 share; // of the light reflected, but for the coat's factors on the way in and out
    float coat; // see diffuseFactor
};

vec3 reflectedAtNormal(MaterialRecord material) {
    return mix(vec3(0.04), material.color, material.metallic);
}

DiffusePart diffusePart(MaterialRecord material) {
    if (isMaterial(material.type, kMaterialMetallicRoughness)) {
        vec3 entering = (1.0 - material.metallic) * (1.0 - reflectedAtNormal(material));
        return DiffusePart(kCoatNormalization * entering * material.color, 1.0);
    }
    return DiffusePart(isMaterial(material.type, kMaterialDiffuse) ? material.color : vec3(0.0), 0.0);
}

bool hasDiffusePart(MaterialRecord material) {
    return isMaterial(material.type, kMaterialDiffuse) ||
           (isMaterial(material.type, kMaterialMetallicRoughness) &&
            (1.0 - material.metallic) * maxComponent(material.color) > 0.0);
}

bool hasLobe(MaterialRecord material) {
    return material.type != kMaterialAbsorber && material.type != kMaterialDiffuse;
}

// The lobe seen from one side: `front` as in Surface.
Lobe lobeOf(MaterialRecord material, bool front) {
    Lobe lobe = Lobe(material.type, material.color, material.extinction, 1.0, 0.0);
    if (isMaterial(material.type, kMaterialDielectric)) {
        lobe.eta = front ? 1.0 / material.ior : material.ior;
    } else if (isMaterial(material.type, kMaterialMetallicRoughness)) {
        lobe.color = reflectedAtNormal(material);
    }
    float alpha = material.roughness * material.roughness;
    bool bends = material.type != kMaterialDielectric || abs(material.ior - 1.0) >= kSmoothIndex;
    lobe.alpha = sceneHasRoughLobes() && alpha >= kSmoothAlpha && bends ? alpha : 0.0;
    return lobe;
}

// Fresnel's equations for the complex index eta + i k, unpolarised.
vec3 fresnelConductor(float cosine, vec3 eta, vec3 k) {
    float cos2 = cosine * cosine;
    float sin2 = 1.0 - cos2;
    vec3 real = eta * eta - k * k - sin2; // of the squared index less sin^2, whose root is a + i b
    vec3 sum = sqrt(real * real + 4.0 * eta * eta * k * k);
    vec3 a = sqrt(max(vec3(0.0), 0.5 * (sum + real)));
    vec3 s = sum + cos2;
    vec3 t = 2.0 * cosine * a;
    vec3 perpendicular = (s - t) / max(s + t, vec3(kTiny));
    vec3 p = cos2 * sum + sin2 * sin2;
    vec3 q = t * sin2;
    vec3 parallel = perpendicular * ((p - q) / max(p + q, vec3(kTiny)));
    return 0.5 * (perpendicular + parallel);
}

// Share of the light that a lobe without transmission reflects off a facet.
vec3 lobeReflectance(Lobe lobe, float cosine) {
    if (isMaterial(lobe.type, kMaterialConductor)) {
        return fresnelConductor(cosine, lobe.color, lobe.extinction);
    }
    if (isMaterial(lobe.type, kMaterialMetallicRoughness)) {
        return lobe.color + (1.0 - lobe.color) * schlickPower(cosine);
    }
    if (isMaterial(lobe.type, kMaterialCustom)) {
        vec4 parameters = vec4(lobe.color, lobe.extinction.x);
        return clamp(customReflectance(uint(lobe.extinction.y), cosine, parameters), 0.0, 1.0);
    }
    return lobe.color;
}

float meanComponent(vec3 v) {
    return (v.x + v.y + v.z) / 3.0;
}

// With which probability a path takes the lobe where it takes one of lobe and diffuse part.
float lobeProbability(MaterialRecord material, Lobe lobe, DiffusePart diffuse, float cosOut) {
    if (!hasDiffusePart(material)) {
        return 1.0;
    }
    if (!hasLobe(material)) {
        return 0.0;
    }
    float reflected_ = meanComponent(lobeReflectance(lobe, cosOut));
    return reflected_ / (reflected_ + meanComponent(diffuse.share) * diffuseFactor(diffuse.coat, cosOut));
}

// Share of the light that leaves the surface again, some of which rough lobes lose.
vec3 leavingShare(MaterialRecord material, Lobe lobe, DiffusePart diffuse, float cosOut) {
    if (!hasLobe(material)) {
        return diffuse.share;
    }
    return (material.type == kMaterialDielectric ? vec3(1.0) : lobeReflectance(lobe, cosOut)) +
           diffuse.share * (diffuseFactor(diffuse.coat, cosOut) / kCoatNormalization);
}

struct BsdfSample {
    vec3 direction; // unit, away from the surface
    vec3 weight;    // BSDF times cosine over density; 0: absorbed
    float pdfW;     // density [1/sr]; 0: smooth, there is no other direction
    bool through;   // to the side where wo is not
};

const BsdfSample kAbsorbed = BsdfSample(vec3(0.0), vec3(0.0), 0.0, false);

// Radiance over the squared index is what refraction conserves: camera paths carry its factor, photons carry flux.
float refractionFactor(Lobe lobe, bool radiance) {
    return radiance ? lobe.eta * lobe.eta : 1.0;
}

BsdfSample sampleSmooth(Lobe lobe, vec3 normal, vec3 wo, float choice, bool radiance) {
    float cosOut = clamp(dot(wo, normal), 0.0, 1.0); // a smoothed normal may be turned away
    vec3 reflection = reflected(-wo, normal);
    if (isMaterial(lobe.type, kMaterialDielectric)) {
        Interface i = meetInterface(cosOut, lobe.eta);
        if (choice >= i.reflectance) {
            return BsdfSample(refracted(-wo, normal, cosOut, i), vec3(refractionFactor(lobe, radiance)), 0.0, true);
        }
        return BsdfSample(reflection, vec3(1.0), 0.0, false);
    }
    return BsdfSample(reflection, lobeReflectance(lobe, cosOut), 0.0, false);
}

// Solid angle of facet normals per solid angle of transmitted directions [Walter07]; the cosine on the far side, where
// the light is transmitted to, is negative.
float refractionJacobian(float eta, float cosOut, float cosIn) {
    float sum = eta * cosOut + cosIn;
    return abs(cosIn) / (sum * sum);
}

// Directions that end up on the wrong side of the true surface, which a smoothed normal may cause, are absorbed.
BsdfSample sampleRough(Lobe lobe, vec3 normal, vec3 geometricNormal, vec3 wo, vec2 u, float choice, bool radiance) {
    vec3 o = intoFrame(wo, normal);
    if (o.z <= 0.0) {
        return kAbsorbed;
    }
    vec3 m = sampleVisibleNormal(o, lobe.alpha, u);
    float cosMicro = clamp(dot(o, m), 0.0, 1.0);
    vec3 i = reflected(-o, m);
    BsdfSample s = BsdfSample(vec3(0.0), vec3(1.0), 1.0, false);
    if (isMaterial(lobe.type, kMaterialDielectric)) {
        Interface facet = meetInterface(cosMicro, lobe.eta);
        s.through = choice >= facet.reflectance;
        s.pdfW = s.through ? 1.0 - facet.reflectance : facet.reflectance;
        i = s.through ? refracted(-o, m, cosMicro, facet) : i;
    } else {
        s.weight = lobeReflectance(lobe, cosMicro);
    }
    s.direction = normalize(fromLocal(i, normal));
    bool below = dot(s.direction, geometricNormal) < 0.0;
    if (cosMicro == 0.0 || (s.through ? i.z >= 0.0 : i.z <= 0.0) || below != s.through) {
        return kAbsorbed;
    }
    float outward = smithLambda(o, lobe.alpha);
    float inward = smithLambda(i, lobe.alpha);
    float visible = ggxDistribution(m, lobe.alpha) / ((1.0 + outward) * o.z); // density of m over its cosine to wo
    if (s.through) {
        // On different sides of the surface masking is uncorrelated [Walter07]
        s.weight *= refractionFactor(lobe, radiance) / (1.0 + inward);
        s.pdfW *= visible * cosMicro * refractionJacobian(lobe.eta, cosMicro, dot(i, m));
    } else {
        s.weight *= (1.0 + outward) / (1.0 + outward + inward);
        s.pdfW *= 0.25 * visible;
    }
    return s;
}

BsdfSample sampleLobe(Lobe lobe, vec3 normal, vec3 geometricNormal, vec3 wo, vec2 u, float choice, bool radiance) {
    if (sceneHasRoughLobes() && lobe.alpha > 0.0) {
        return sampleRough(lobe, normal, geometricNormal, wo, u, choice, radiance);
    }
    return sampleSmooth(lobe, normal, wo, choice, radiance);
}

struct BsdfValue {
    vec3 fCos;  // BSDF for radiance times the cosine of wi [1/sr]
    float pdfW; // density with which sampleLobe takes wi [1/sr]
};

// Of a rough lobe.
BsdfValue evaluateLobe(Lobe lobe, vec3 normal, vec3 geometricNormal, vec3 wo, vec3 wi) {
    BsdfValue nothing = BsdfValue(vec3(0.0), 0.0);
    vec3 o = intoFrame(wo, normal);
    vec3 i = intoFrame(wi, normal);
    bool through = i.z < 0.0;
    bool below = dot(wi, geometricNormal) < 0.0;
    if (o.z <= 0.0 || i.z == 0.0 || below != through || (through && lobe.type != kMaterialDielectric)) {
        return nothing;
    }
    vec3 m = normalize(through ? lobe.eta * o + i : o + i);
    m = m.z < 0.0 ? -m : m;
    float cosMicro = min(dot(o, m), 1.0);
    float cosIn = dot(i, m);
    if (cosMicro <= 0.0 || (through ? cosIn >= 0.0 : cosIn <= 0.0)) {
        return nothing;
    }
    vec3 weight = vec3(1.0);
    float pdfW = ggxDistribution(m, lobe.alpha) / ((1.0 + smithLambda(o, lobe.alpha)) * o.z);
    if (lobe.type == kMaterialDielectric) {
        float reflectance = meetInterface(cosMicro, lobe.eta).reflectance;
        pdfW *= through ? 1.0 - reflectance : reflectance;
    } else {
        weight = lobeReflectance(lobe, cosMicro);
    }
    float inward = smithLambda(i, lobe.alpha);
    if (through) {
        pdfW *= cosMicro * refractionJacobian(lobe.eta, cosMicro, cosIn);
        weight *= refractionFactor(lobe, true) / (1.0 + inward);
    } else {
        pdfW *= 0.25;
        float outward = smithLambda(o, lobe.alpha);
        weight *= (1.0 + outward) / (1.0 + outward + inward);
    }
    return BsdfValue(weight * pdfW, pdfW);
}
#endif
