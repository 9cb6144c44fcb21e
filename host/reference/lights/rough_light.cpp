#include "reference/lights/rough_light.h"

namespace hyalite::reference {

double powerHeuristic(double pdf, double other) {
    return pdf * pdf / (pdf * pdf + other * other);
}

std::optional<LightSample> sampleRoughLight(const World& world, const RoughPoint& x, std::uint32_t pass,
                                            std::optional<std::uint32_t> light, double shift) {
    const LightArrival arrival =
        sampleArrival(world, x.surface.position,
                      {.depth = x.depth, .samplerSeed = x.samplerSeed, .pass = pass, .light = light, .shift = shift});
    const glm::dvec3& wi = arrival.direction;
    const ShadingNormals normals{x.surface.normal, x.surface.geometricNormal};
    const BsdfValue value = evaluateLobe(x.lobe, normals, x.wo, wi, Transport::Radiance);
    const double weight = arrival.pdfW > 0 ? powerHeuristic(arrival.pdfW, value.pdfW) : 1;
    const glm::dvec3 contribution =
        x.beta * value.f * arrival.irradiance * (weight * std::abs(glm::dot(wi, x.surface.normal)));
    if (contribution == glm::dvec3(0)) {
        return std::nullopt;
    }
    const bool through = glm::dot(wi, x.surface.geometricNormal) < 0;
    return inMedia(world, {.from = leave(x.surface, wi),
                           .to = arrival.shadowEnd,
                           .contribution = contribution,
                           .media = through ? x.beyond : x.media,
                           .passes = world.hasStraightGlass && arrival.pdfW == 0});
}

glm::dvec3 directRoughLight(const World& world, const RoughPoint& x, std::uint32_t pass) {
    const auto sample = sampleRoughLight(world, x, pass, std::nullopt);
    return sample ? arriving(world, *sample) : glm::dvec3(0);
}

} // namespace hyalite::reference
