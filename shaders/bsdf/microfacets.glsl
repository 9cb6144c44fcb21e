// Sampling and evaluation of a lobe: smooth (no density) or rough by GGX microfacets [Walter07]. Rough lobes model a
// single facet reflection: light reflected from facet to facet is lost, more so with greater roughness.
#ifndef HYALITE_MICROFACETS_GLSL
#define HYALITE_MICROFACETS_GLSL
#include "bsdf/ggx.glsl"
#include "bsdf/interface.glsl"
#include "bsdf/parts.glsl"

vec3 lobeReflectance(Lobe lobe, float cosine); // see bsdf.glsl, both
float overLobe(Lobe lobe, float cosine);

// Refraction conserves radiance over the squared index: camera paths carry that factor, photons carry flux.
float refractionFactor(Lobe lobe, uint transport) {
    return transport == kRadiance ? lobe.eta * lobe.eta : 1.0;
}

BsdfSample sampleSmooth(Lobe lobe, vec3 normal, vec3 wo, float choice, uint transport) {
    float cosOut = clamp(dot(wo, normal), 0.0, 1.0); // a smoothed normal may face away
    vec3 reflection = reflected(-wo, normal);
    if (lobe.transmits) {
        Interface i = meetLobe(lobe, cosOut);
        if (choice >= i.reflectance) {
            return BsdfSample(refracted(-wo, normal, cosOut, i), vec3(refractionFactor(lobe, transport)), 0.0, true);
        }
        return BsdfSample(reflection, vec3(1.0), 0.0, false);
    }
    float over = overLobe(lobe, cosOut);
    return BsdfSample(reflection, lobeReflectance(lobe, cosOut) * (over * over), 0.0, false);
}

// Solid angle of facet normals per solid angle of transmitted directions [Walter07]; the cosine on the far side, to
// which the light is transmitted, is negative.
float refractionJacobian(float eta, float cosOut, float cosIn) {
    float sum = eta * cosOut + cosIn;
    return abs(cosIn) / (sum * sum);
}

// Directions on the wrong side of the geometric surface, which a smoothed normal may cause, are absorbed.
BsdfSample sampleRough(Lobe lobe, vec3 normal, vec3 geometricNormal, vec3 wo, vec2 u, float choice, uint transport) {
    vec3 o = intoFrame(wo, normal);
    if (o.z <= 0.0) {
        return kAbsorbed;
    }
    vec3 m = sampleVisibleNormal(o, lobe.alpha, u);
    float cosMicro = clamp(dot(o, m), 0.0, 1.0);
    vec3 i = reflected(-o, m);
    BsdfSample s = BsdfSample(vec3(0.0), vec3(1.0), 1.0, false);
    if (lobe.transmits) {
        Interface facet = meetInterface(cosMicro, lobe.eta);
        s.through = choice >= facet.reflectance;
        s.pdfW = s.through ? 1.0 - facet.reflectance : facet.reflectance;
        i = s.through ? refracted(-o, m, cosMicro, facet) : i;
    } else {
        s.weight = lobeReflectance(lobe, cosMicro) * (overLobe(lobe, o.z) * overLobe(lobe, abs(i.z)));
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
        s.weight *= refractionFactor(lobe, transport) / (1.0 + inward);
        s.pdfW *= visible * cosMicro * refractionJacobian(lobe.eta, cosMicro, dot(i, m));
    } else {
        s.weight *= (1.0 + outward) / (1.0 + outward + inward);
        s.pdfW *= 0.25 * visible;
    }
    return s;
}

BsdfSample sampleLobe(Lobe lobe, vec3 normal, vec3 geometricNormal, vec3 wo, vec2 u, float choice, uint transport) {
    if (sceneHasRoughLobes() && lobe.alpha > 0.0) {
        return sampleRough(lobe, normal, geometricNormal, wo, u, choice, transport);
    }
    return sampleSmooth(lobe, normal, wo, choice, transport);
}

// Value and densities of a rough lobe.
BsdfValue evaluateLobe(Lobe lobe, vec3 normal, vec3 geometricNormal, vec3 wo, vec3 wi, uint transport) {
    vec3 o = intoFrame(wo, normal);
    vec3 i = intoFrame(wi, normal);
    bool through = i.z < 0.0;
    bool below = dot(wi, geometricNormal) < 0.0;
    if (o.z <= 0.0 || i.z == 0.0 || below != through || (through && !lobe.transmits)) {
        return kNoValue;
    }
    vec3 m = normalize(through ? lobe.eta * o + i : o + i);
    m = m.z < 0.0 ? -m : m;
    float cosMicro = min(dot(o, m), 1.0);
    float cosIn = dot(i, m);
    if (cosMicro <= 0.0 || (through ? cosIn >= 0.0 : cosIn <= 0.0)) {
        return kNoValue;
    }
    vec3 weight = vec3(1.0);
    float outward = smithLambda(o, lobe.alpha);
    float inward = smithLambda(i, lobe.alpha);
    float D = ggxDistribution(m, lobe.alpha);
    float pdfW = D / ((1.0 + outward) * o.z);
    float reversePdfW = D / ((1.0 + inward) * abs(i.z));
    if (lobe.transmits) {
        float reflectance = meetInterface(cosMicro, lobe.eta).reflectance; // the same seen from wi
        pdfW *= through ? 1.0 - reflectance : reflectance;
        reversePdfW *= through ? 1.0 - reflectance : reflectance;
    } else {
        weight = lobeReflectance(lobe, cosMicro) * (overLobe(lobe, o.z) * overLobe(lobe, i.z));
    }
    if (through) {
        pdfW *= cosMicro * refractionJacobian(lobe.eta, cosMicro, cosIn);
        reversePdfW *= -cosIn * refractionJacobian(1.0 / lobe.eta, -cosIn, -cosMicro);
        weight *= refractionFactor(lobe, transport) / (1.0 + inward);
    } else {
        pdfW *= 0.25;
        reversePdfW *= 0.25;
        weight *= (1.0 + outward) / (1.0 + outward + inward);
    }
    return BsdfValue(weight * pdfW, pdfW, reversePdfW);
}
#endif
