// Light straight from the lamps.
#include "parity/twins.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <numbers>

namespace hyalite::parity {

namespace {

using glm::dvec3;

std::optional<std::uint32_t> lightOf(std::uint32_t number) {
    return number == shared::kNone ? std::nullopt : std::optional(number);
}

// Shadow rays to lights beyond the scene have no end worth comparing.
constexpr double kFar = 1e20;

// Light below this share of what a lobe of 1/sr would send is none.
constexpr double kNothing = 0x1p-16;

Answer answerOf(const std::optional<reference::LightSample>& sample) {
    Answer answer;
    answer.exact("sampled", sample ? 1 : 0);
    if (sample) {
        const dvec3 way = sample->to - sample->from;
        const double distance = glm::length(way);
        answer.vector("origin", sample->from);
        answer.vector("direction", way / distance);
        if (distance < kFar) {
            answer.number("distance", distance);
        }
        answer.vector("contribution", sample->contribution);
    }
    return answer;
}

} // namespace

void compareSampleLights(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SampleLightsArguments>();
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, args.count);
    const auto rays = stage.seen.after<shared::Ray>(args.shadowRays, args.count);
    const auto contributions = stage.seen.after<glm::vec3>(args.contributions, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[i];
        std::optional<reference::LightSample> sampled;
        if (rays[i].tMax > 0) {
            const dvec3 from(rays[i].origin);
            const double distance = std::min(double{rays[i].tMax}, reference::kBeyond);
            sampled = reference::LightSample{.from = from,
                                             .to = from + distance * glm::normalize(dvec3(rays[i].direction)),
                                             .contribution = dvec3(contributions[i])};
        }
        stage.compare(
            i, answerOf(sampled),
            [&](Nudge nudge) {
                const bool isOfBounce = args.bounceDepth == 0 || args.bounceDepth == point.depth;
                if (point.depth == 0 || point.depth + 1 > args.maxDepth || !isOfBounce) {
                    return answerOf(std::nullopt);
                }
                reference::VisiblePoint x = stage.sides.toTwin(point);
                x.position = nudge.point(x.position, stage.sides.scale());
                x.shadowOrigin = x.position;
                x.normal = nudge.direction(x.normal);
                auto sample =
                    reference::sampleLight(stage.sides.world(), x, args.pass, lightOf(args.light), nudge.shift());
                if (sample && args.bounceDepth != 0 &&
                    sample->pdfW > 0) { // a ray by the cosine may meet the same place
                    sample->contribution *= reference::powerHeuristic(sample->pdfW, sample->cosine / std::numbers::pi);
                }
                if (sample && largestComponent(sample->contribution) < double{std::numeric_limits<float>::min()}) {
                    sample.reset(); // black material, or less than a float holds
                }
                return answerOf(sample);
            },
            [&] {
                return OffenderInputs{{"position", describe(dvec3(point.position))},
                                      {"normal", describe(dvec3(point.normal))},
                                      {"f", describe(dvec3(point.f))},
                                      {"pixel", std::to_string(point.pixel)}};
            });
    }
}

void compareSampleRoughLights(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SampleRoughLightsArguments>();
    const auto points = stage.seen.before<shared::RoughPoint>(args.roughPoints, args.count);
    const std::size_t all = SIZE_MAX / 1024;
    const auto before = stage.seen.before<glm::vec3>(args.direct, all);
    const auto after = stage.seen.after<glm::vec3>(args.direct, all);
    const Sides& sides = stage.sides;
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::RoughPoint& point = points[i];
        if (point.depth == 0) {
            continue;
        }
        // Where a lobe sends next to nothing, what is left is a difference of numbers close to 1
        const auto arrival = reference::sampleArrival(
            sides.world(), dvec3(point.position),
            {.depth = point.depth, .samplerSeed = point.samplerSeed, .pass = args.pass, .light = lightOf(args.light)});
        const double nothing = kNothing * largestComponent(dvec3(point.beta) * arrival.irradiance);
        const auto lightAdded = [&](const dvec3& added) {
            Answer answer;
            answer.exact("added", largestComponent(added) > nothing ? 1 : 0);
            if (largestComponent(added) > nothing) {
                answer.vector("direct", dvec3(before[point.result]) + added);
            }
            return answer;
        };
        const Answer device = lightAdded(dvec3(after[point.result]) - dvec3(before[point.result]));
        stage.compare(
            i, device,
            [&](Nudge nudge) {
                reference::RoughPoint x = sides.toTwin(point);
                x.surface.position = nudge.point(x.surface.position, sides.scale());
                x.surface.normal = nudge.direction(x.surface.normal);
                x.wo = nudge.direction(x.wo);
                const auto sample =
                    reference::sampleRoughLight(sides.world(), x, args.pass, lightOf(args.light), nudge.shift());
                bool isSeen = sample.has_value();
                if (isSeen) {
                    const dvec3 way = sample->to - sample->from;
                    const double distance = glm::length(way);
                    const bool through = glm::dot(way, x.surface.geometricNormal) < 0;
                    isSeen = !sides.trace({.origin = sample->from, .direction = way / distance, .tMax = distance},
                                          through ? point.from ^ shared::kRayInside : point.from);
                }
                const dvec3 light = isSeen ? sample->contribution : dvec3(0);
                return lightAdded(glm::vec3(before[point.result]) + glm::vec3(light) == before[point.result] ? dvec3(0)
                                                                                                             : light);
            },
            [&] {
                return OffenderInputs{{"position", describe(dvec3(point.position))},
                                      {"normal", describe(dvec3(point.normal))},
                                      {"wo", describe(dvec3(point.wo))},
                                      {"alpha", describe(double{point.lobe.alpha})},
                                      {"result", std::to_string(point.result)}};
            });
    }
}

} // namespace hyalite::parity
