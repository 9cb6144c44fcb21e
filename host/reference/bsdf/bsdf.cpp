#include "reference/bsdf/bsdf.h"

#include "reference/bsdf/ggx.h"
#include "reference/bsdf/interface.h"
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

const BsdfModel* modelOf(const MaterialModel& material) {
    switch (material.type) {
#define ROW(Name, name)                                                                                                \
    case shared::kMaterial##Name:                                                                                      \
        return &k##Name##Bsdf;
        HYALITE_MODELS(ROW)
#undef ROW
    default:
        return nullptr;
    }
}

glm::dvec3 intoFrame(const glm::dvec3& v, const glm::dvec3& normal) {
    const Basis basis = orthonormalBasis(normal);
    return {glm::dot(v, basis.tangent), glm::dot(v, basis.bitangent), glm::dot(v, normal)};
}

glm::dvec3 fromFrame(const glm::dvec3& v, const glm::dvec3& normal) {
    const Basis basis = orthonormalBasis(normal);
    return v.x * basis.tangent + v.y * basis.bitangent + v.z * normal;
}

// True if wi lies on the side given by `through` with respect to both normals.
bool isOnSide(const ShadingNormals& normals, const glm::dvec3& wi, bool through) {
    const double side = through ? -1 : 1;
    return side * glm::dot(wi, normals.normal) > 0 && side * glm::dot(wi, normals.geometricNormal) >= 0;
}

// Reflection at microfacets: [Walter07] (20) with the Jacobian (14), and height-correlated masking of i and o
// [Heitz14].
BsdfValue evaluateReflection(const Lobe& lobe, const glm::dvec3& o, const glm::dvec3& i) {
    const glm::dvec3 m = glm::normalize(o + i);
    const double cosMicro = glm::dot(o, m);
    const glm::dvec3 F = facetReflectance(lobe, cosMicro) * (overLobe(lobe, o.z) * overLobe(lobe, i.z));
    const double taken = lobe.transmits ? F.x : 1.0; // the path may be refracted instead
    const double G = 1 / (1 + smithLambda(o, lobe.alpha) + smithLambda(i, lobe.alpha));
    return {.f = F * (ggxDistribution(m, lobe.alpha) * G / (4 * o.z * i.z)),
            .pdfW = taken * visibleNormalDensity(o, m, lobe.alpha) / (4 * cosMicro),
            .reversePdfW = taken * visibleNormalDensity(i, m, lobe.alpha) / (4 * cosMicro)};
}

// Refraction: [Walter07] (21) with (16) and (17); both sides of (21) are divided by the squared index of wi's side. The
// two sides are masked independently.
BsdfValue evaluateRefraction(const Lobe& lobe, const glm::dvec3& o, const glm::dvec3& i, Transport transport) {
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
    const double reverseJacobian =
        cosOut / std::pow(cosIn / lobe.eta + cosOut, 2); // density of wo among the directions that wi is refracted to
    const double D = ggxDistribution(m, lobe.alpha);
    const double G = smithG1(o, lobe.alpha) * smithG1(i, lobe.alpha);
    const double scale = transport == Transport::Radiance ? lobe.eta * lobe.eta : 1;
    return {.f = glm::dvec3(scale * transmitted * D * G * jacobian * cosOut / (o.z * std::abs(i.z))),
            .pdfW = transmitted * visibleNormalDensity(o, m, lobe.alpha) * jacobian,
            .reversePdfW = transmitted * visibleNormalDensity(-i, m, lobe.alpha) * reverseJacobian};
}

// Share of the light that the lobe reflects, averaged over the channels.
double shareOf(const Lobe& lobe, double cosOut) {
    return mean(facetReflectance(lobe, cosOut)) * overLobe(lobe, cosOut);
}

// Probability that a path takes the coat, given that it takes a lobe.
double coatProbability(const Lobe& lobe, const Lobe& coat, double cosOut) {
    const double ofCoat = shareOf(coat, cosOut);
    return ofCoat > 0 ? ofCoat / (ofCoat + shareOf(lobe, cosOut)) : 0;
}

BsdfSample sampleSmooth(const Lobe& lobe, const glm::dvec3& normal, const glm::dvec3& wo, double choice,
                        Transport transport) {
    const double cosOut = incidentCosine(-wo, normal);
    if (lobe.transmits) {
        const auto refracted = refract(-wo, normal, lobe.eta);
        if (refracted && choice >= facetReflectance(lobe, cosOut).x) {
            const double scale = transport == Transport::Radiance ? lobe.eta * lobe.eta : 1;
            return {.direction = *refracted, .weight = glm::dvec3(scale), .through = true};
        }
        return {.direction = reflect(-wo, normal), .weight = glm::dvec3(1)};
    }
    return {.direction = reflect(-wo, normal),
            .weight = facetReflectance(lobe, cosOut) * std::pow(overLobe(lobe, cosOut), 2)};
}

} // namespace

double facetAlpha(double roughness) {
    const double alpha = roughness * roughness;
    return alpha >= double{shared::kSmoothAlpha} ? alpha : 0;
}

std::uint32_t lobeFlag(double roughness) {
    return facetAlpha(roughness) > 0 ? shared::kBsdfGlossy : shared::kBsdfSpecular;
}

std::uint32_t bsdfFlags(const MaterialModel& material) {
    const BsdfModel* model = modelOf(material);
    return model != nullptr ? model->flags(material) : 0;
}

double DiffusePart::letThrough(double cosine) const {
    return modelOf(material)->overDiffuse(material, cosine);
}

double DiffusePart::meanLetThrough() const {
    return modelOf(material)->meanOverDiffuse(material);
}

std::optional<DiffusePart> diffusePart(const MaterialModel& material) {
    if ((bsdfFlags(material) & shared::kBsdfDiffuse) == 0) {
        return std::nullopt;
    }
    return DiffusePart{.material = material, .share = modelOf(material)->albedo(material)};
}

glm::dvec3 diffuseReflectance(const DiffusePart& diffuse, double cosOut, double cosIn) {
    return diffuse.share * (diffuse.letThrough(cosOut) * diffuse.letThrough(cosIn));
}

std::optional<Lobe> lobeOf(const MaterialModel& material, bool front) {
    const BsdfModel* model = modelOf(material);
    return model != nullptr && model->lobe != nullptr ? std::optional(model->lobe(material, front)) : std::nullopt;
}

glm::dvec3 facetReflectance(const Lobe& lobe, double cosine) {
    return modelOf(lobe.material)->reflectance(lobe, std::clamp(cosine, 0.0, 1.0));
}

std::optional<Lobe> coatOf(const MaterialModel& material) {
    const BsdfModel* model = modelOf(material);
    return model != nullptr && model->coat != nullptr ? std::optional(model->coat(material)) : std::nullopt;
}

double overLobe(const Lobe& lobe, double cosine) {
    const auto over = modelOf(lobe.material)->overLobe;
    return over != nullptr && !lobe.isCoat ? over(lobe.material, cosine) : 1;
}

PickedLobe pickLobe(const Lobe& lobe, double cosOut, double choice) {
    const std::optional<Lobe> coat = coatOf(lobe.material);
    const double ofCoat = coat ? coatProbability(lobe, *coat, cosOut) : 0;
    return choice < ofCoat ? PickedLobe{*coat, ofCoat} : PickedLobe{lobe, 1 - ofCoat};
}

double lobeProbability(const std::optional<Lobe>& lobe, const std::optional<DiffusePart>& diffuse, double cosOut) {
    if (!lobe || !diffuse) {
        return lobe ? 1 : 0;
    }
    const std::optional<Lobe> coat = coatOf(lobe->material);
    const double reflected = shareOf(*lobe, cosOut) + (coat ? shareOf(*coat, cosOut) : 0);
    return reflected / (reflected + mean(diffuse->share) * diffuse->letThrough(cosOut));
}

std::optional<BsdfSample> sampleLobe(const Lobe& lobe, const ShadingNormals& normals, const glm::dvec3& wo,
                                     glm::dvec2 uv, double choice, Transport transport) {
    if (lobe.alpha == 0) {
        return sampleSmooth(lobe, normals.normal, wo, choice, transport);
    }
    const glm::dvec3 o = intoFrame(wo, normals.normal);
    if (o.z <= 0) {
        return std::nullopt;
    }
    const glm::dvec3 m = fromFrame(sampleVisibleNormal(o, lobe.alpha, uv), normals.normal);
    BsdfSample sample{.direction = reflect(-wo, m), .weight = {}};
    if (lobe.transmits) {
        const auto refracted = refract(-wo, m, lobe.eta);
        sample.through = refracted && choice >= fresnelDielectric(incidentCosine(-wo, m), lobe.eta);
        sample.direction = sample.through ? *refracted : sample.direction;
    }
    if (!isOnSide(normals, sample.direction, sample.through)) {
        return std::nullopt;
    }
    const BsdfValue value = evaluateLobe(lobe, normals, wo, sample.direction, transport);
    if (value.pdfW <= 0) {
        return std::nullopt;
    }
    sample.pdfW = value.pdfW;
    sample.weight = value.f * (std::abs(glm::dot(sample.direction, normals.normal)) / value.pdfW);
    return sample;
}

BsdfValue evaluateLobe(const Lobe& lobe, const ShadingNormals& normals, const glm::dvec3& wo, const glm::dvec3& wi,
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
    return lobe.transmits ? evaluateRefraction(lobe, o, i, transport) : BsdfValue{};
}

std::optional<BsdfSample> sampleBsdf(const MaterialModel& material, bool front, const ShadingNormals& normals,
                                     const glm::dvec3& wo, glm::dvec2 uv, double choice, Transport transport) {
    const std::optional<DiffusePart> diffuse = diffusePart(material);
    const std::optional<Lobe> lobe = lobeOf(material, front);
    const double cosOut = incidentCosine(-wo, normals.normal);
    const double probability = lobeProbability(lobe, diffuse, cosOut);
    std::optional<BsdfSample> sample;
    double taken = probability;
    if (choice < probability) {
        const PickedLobe picked = pickLobe(*lobe, cosOut, choice / probability);
        taken *= picked.probability;
        sample = sampleLobe(picked.lobe, normals, wo, uv, choice / probability, transport);
    } else if (diffuse) {
        taken = 1 - probability;
        const glm::dvec3 direction = cosineHemisphere(uv, normals.normal);
        const double cosine = glm::dot(direction, normals.normal);
        sample = BsdfSample{.direction = direction,
                            .weight = diffuseReflectance(*diffuse, cosOut, cosine),
                            .pdfW = cosine / std::numbers::pi};
    }
    if (sample) {
        sample->weight /= taken;
        sample->pdfW *= taken;
    }
    return sample;
}

BsdfValue evaluateBsdf(const MaterialModel& material, bool front, const ShadingNormals& normals, const glm::dvec3& wo,
                       const glm::dvec3& wi, Transport transport) {
    const std::optional<DiffusePart> diffuse = diffusePart(material);
    const std::optional<Lobe> lobe = lobeOf(material, front);
    const double cosOut = glm::dot(wo, normals.normal);
    const double cosIn = glm::dot(wi, normals.normal);
    BsdfValue value;
    if (diffuse && cosOut > 0 && cosIn > 0) {
        value.f = diffuseReflectance(*diffuse, cosOut, cosIn) / std::numbers::pi;
        value.pdfW = (1 - lobeProbability(lobe, diffuse, cosOut)) * cosIn / std::numbers::pi;
        value.reversePdfW = (1 - lobeProbability(lobe, diffuse, cosIn)) * cosOut / std::numbers::pi;
    }
    const std::optional<Lobe> coat = coatOf(material);
    const auto add = [&](const Lobe& one, const auto& probability) {
        if (one.alpha > 0) {
            const BsdfValue rough = evaluateLobe(one, normals, wo, wi, transport);
            value.f += rough.f;
            value.pdfW += lobeProbability(lobe, diffuse, cosOut) * probability(cosOut) * rough.pdfW;
            value.reversePdfW += lobeProbability(lobe, diffuse, cosIn) * probability(cosIn) * rough.reversePdfW;
        }
    };
    const auto ofCoat = [&](double cosine) { return coat ? coatProbability(*lobe, *coat, cosine) : 0; };
    if (lobe) {
        add(*lobe, [&](double cosine) { return 1 - ofCoat(cosine); });
    }
    if (coat) {
        add(*coat, ofCoat);
    }
    return value;
}

} // namespace hyalite::reference
