#include "reference/bsdf/bsdf.h"

#include "reference/bsdf/custom_twins.h"
#include "reference/bsdf/ggx.h"
#include "reference/bsdf/materials.h"
#include "reference/lib/sampling.h"

#include "shaders/shared/limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hyalite::reference {

namespace {

double mean(const glm::dvec3& c) {
    return (c.x + c.y + c.z) / 3;
}

double roughnessOf(const MaterialModel& model) {
    if (const auto* glass = std::get_if<Dielectric>(&model)) {
        return std::abs(glass->ior - 1) < double{shared::kSmoothIndex} ? 0 : glass->roughness;
    }
    if (const auto* metal = std::get_if<Conductor>(&model)) {
        return metal->roughness;
    }
    if (const auto* custom = std::get_if<CustomReflectance>(&model)) {
        return custom->roughness;
    }
    const auto* both = std::get_if<MetallicRoughness>(&model);
    return both != nullptr ? both->roughness : 0;
}

// What metallic-roughness reflects at normal incidence.
glm::dvec3 normalReflectance(const MetallicRoughness& material) {
    return glm::mix(glm::dvec3(0.04), material.baseColor, material.metallic);
}

glm::dvec3 intoFrame(const glm::dvec3& v, const glm::dvec3& normal) {
    const Basis basis = orthonormalBasis(normal);
    return {glm::dot(v, basis.tangent), glm::dot(v, basis.bitangent), glm::dot(v, normal)};
}

glm::dvec3 fromFrame(const glm::dvec3& v, const glm::dvec3& normal) {
    const Basis basis = orthonormalBasis(normal);
    return v.x * basis.tangent + v.y * basis.bitangent + v.z * normal;
}

// Is wi on the side that `through` says, of both normals?
bool isOnSide(const ShadingNormals& normals, const glm::dvec3& wi, bool through) {
    const double side = through ? -1 : 1;
    return side * glm::dot(wi, normals.normal) > 0 && side * glm::dot(wi, normals.geometricNormal) >= 0;
}

// Reflection at microfacets: [Walter07] (20) with the jacobian (14); i and o masked by the same heights [Heitz14].
LobeValue evaluateReflection(const Lobe& lobe, const glm::dvec3& o, const glm::dvec3& i) {
    const glm::dvec3 m = glm::normalize(o + i);
    const double cosMicro = glm::dot(o, m);
    const bool isGlass = std::holds_alternative<Dielectric>(lobe.model);
    const glm::dvec3 F = facetReflectance(lobe, cosMicro);
    const double G = 1 / (1 + smithLambda(o, lobe.alpha) + smithLambda(i, lobe.alpha));
    return {.f = F * (ggxDistribution(m, lobe.alpha) * G / (4 * o.z * i.z)),
            .pdfW = (isGlass ? F.x : 1.0) * visibleNormalDensity(o, m, lobe.alpha) / (4 * cosMicro)};
}

// Refraction: [Walter07] (21) with (16) and (17), both sides of (21) over the squared index of wi's side; masked
// separately on the two sides.
LobeValue evaluateRefraction(const Lobe& lobe, const glm::dvec3& o, const glm::dvec3& i, Transport transport) {
    glm::dvec3 m = glm::normalize(lobe.eta * o + i);
    if (m.z < 0) {
        m = -m;
    }
    const double cosOut = glm::dot(o, m);
    const double cosIn = glm::dot(i, m);
    if (cosOut <= 0 || cosIn >= 0) {
        return {};
    }
    const double transmitted = 1 - fresnelDielectric(std::min(cosOut, 1.0), lobe.eta);
    const double jacobian = std::abs(cosIn) / std::pow(lobe.eta * cosOut + cosIn, 2);
    const double D = ggxDistribution(m, lobe.alpha);
    const double G = smithG1(o, lobe.alpha) * smithG1(i, lobe.alpha);
    const double scale = transport == Transport::Radiance ? lobe.eta * lobe.eta : 1;
    return {.f = glm::dvec3(scale * transmitted * D * G * jacobian * cosOut / (o.z * std::abs(i.z))),
            .pdfW = transmitted * visibleNormalDensity(o, m, lobe.alpha) * jacobian};
}

LobeSample sampleSmooth(const Lobe& lobe, const glm::dvec3& normal, const glm::dvec3& wo, double choice,
                        Transport transport) {
    const double cosOut = incidentCosine(-wo, normal);
    if (std::holds_alternative<Dielectric>(lobe.model)) {
        const auto refracted = refract(-wo, normal, lobe.eta);
        if (refracted && choice >= fresnelDielectric(cosOut, lobe.eta)) {
            const double scale = transport == Transport::Radiance ? lobe.eta * lobe.eta : 1;
            return {.direction = *refracted, .weight = glm::dvec3(scale), .through = true};
        }
        return {.direction = reflect(-wo, normal), .weight = glm::dvec3(1)};
    }
    return {.direction = reflect(-wo, normal), .weight = facetReflectance(lobe, cosOut)};
}

} // namespace

std::optional<DiffusePart> diffusePart(const MaterialModel& model) {
    if (const auto* diffuse = std::get_if<Diffuse>(&model)) {
        return DiffusePart{.share = diffuse->albedo};
    }
    const auto* material = std::get_if<MetallicRoughness>(&model);
    if (material == nullptr || (1 - material->metallic) * glm::length(material->baseColor) == 0) {
        return std::nullopt;
    }
    // [Shirley97a]: what enters the coat is 1 - F(cosIn), what leaves it the same of cosOut; 21/20 makes reflected and
    // scattered light add up to all of it where the base is white.
    return DiffusePart{.share = 21.0 / 20 * (1 - material->metallic) * material->baseColor *
                                (1.0 - normalReflectance(*material)),
                       .coated = true};
}

glm::dvec3 diffuseReflectance(const DiffusePart& diffuse, double cosOut, double cosIn) {
    return diffuse.coated ? diffuse.share * (coatTransmission(cosOut) * coatTransmission(cosIn)) : diffuse.share;
}

std::optional<Lobe> lobeOf(const MaterialModel& model, bool front) {
    if (std::holds_alternative<Diffuse>(model)) {
        return std::nullopt;
    }
    Lobe lobe{.model = model};
    if (const auto* glass = std::get_if<Dielectric>(&model)) {
        lobe.eta = front ? 1 / glass->ior : glass->ior;
    }
    const double alpha = roughnessOf(model) * roughnessOf(model);
    lobe.alpha = alpha >= double{shared::kSmoothAlpha} ? alpha : 0;
    return lobe;
}

glm::dvec3 facetReflectance(const Lobe& lobe, double cosine) {
    const double c = std::clamp(cosine, 0.0, 1.0);
    if (const auto* mirror = std::get_if<Mirror>(&lobe.model)) {
        return mirror->reflectance;
    }
    if (const auto* metal = std::get_if<Conductor>(&lobe.model)) {
        return {fresnelConductor(c, metal->eta.x, metal->k.x), fresnelConductor(c, metal->eta.y, metal->k.y),
                fresnelConductor(c, metal->eta.z, metal->k.z)};
    }
    if (const auto* material = std::get_if<MetallicRoughness>(&lobe.model)) {
        return 1.0 - (1.0 - normalReflectance(*material)) * coatTransmission(c);
    }
    if (const auto* custom = std::get_if<CustomReflectance>(&lobe.model)) {
        return glm::clamp(customReflectanceTwin(*custom->code)(c, custom->parameters), 0.0, 1.0);
    }
    return glm::dvec3(fresnelDielectric(c, lobe.eta));
}

double lobeProbability(const std::optional<Lobe>& lobe, const std::optional<DiffusePart>& diffuse, double cosOut) {
    if (!lobe || !diffuse) {
        return lobe ? 1 : 0;
    }
    const double reflected = mean(facetReflectance(*lobe, cosOut));
    return reflected / (reflected + mean(diffuse->share) * coatTransmission(cosOut));
}

std::optional<LobeSample> sampleLobe(const Lobe& lobe, const ShadingNormals& normals, const glm::dvec3& wo,
                                     glm::dvec2 uv, double choice, Transport transport) {
    if (lobe.alpha == 0) {
        return sampleSmooth(lobe, normals.normal, wo, choice, transport);
    }
    const glm::dvec3 o = intoFrame(wo, normals.normal);
    if (o.z <= 0) {
        return std::nullopt;
    }
    const glm::dvec3 m = fromFrame(sampleVisibleNormal(o, lobe.alpha, uv), normals.normal);
    LobeSample sample{.direction = reflect(-wo, m), .weight = {}};
    if (std::holds_alternative<Dielectric>(lobe.model)) {
        const auto refracted = refract(-wo, m, lobe.eta);
        sample.through = refracted && choice >= fresnelDielectric(incidentCosine(-wo, m), lobe.eta);
        sample.direction = sample.through ? *refracted : sample.direction;
    }
    if (!isOnSide(normals, sample.direction, sample.through)) {
        return std::nullopt;
    }
    const LobeValue value = evaluateLobe(lobe, normals, wo, sample.direction, transport);
    if (value.pdfW <= 0) {
        return std::nullopt;
    }
    sample.pdfW = value.pdfW;
    sample.weight = value.f * (std::abs(glm::dot(sample.direction, normals.normal)) / value.pdfW);
    return sample;
}

LobeValue evaluateLobe(const Lobe& lobe, const ShadingNormals& normals, const glm::dvec3& wo, const glm::dvec3& wi,
                       Transport transport) {
    const glm::dvec3 o = intoFrame(wo, normals.normal);
    const glm::dvec3 i = intoFrame(wi, normals.normal);
    const bool through = i.z < 0;
    if (o.z <= 0 || !isOnSide(normals, wi, through)) {
        return {};
    }
    if (!through) {
        return evaluateReflection(lobe, o, i);
    }
    return std::holds_alternative<Dielectric>(lobe.model) ? evaluateRefraction(lobe, o, i, transport) : LobeValue{};
}

} // namespace hyalite::reference
