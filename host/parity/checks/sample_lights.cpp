// Light that comes straight to visible points.
#include "parity/checks/checks.h"

#include "parity/checks/light_samples.h"
#include "parity/checks/visible_points.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <limits>
#include <numbers>

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct LightFields : FieldSet<5> {
    const Field& sampled = exact("sampled", kGrazing);
    const Field& origin = place("origin");
    const Field& direction = angle("direction", kBounce);
    const Field& distance = number("distance", kPosition, Scale::Scene);
    const Field& contribution = vector("contribution", kWeight);
};
constexpr LightFields kLight;

// Shadow rays to lights beyond the scene have no end worth comparing.
constexpr double kFar = 1e20;

Answer answerOf(const std::optional<reference::LightSample>& sample) {
    Answer answer;
    answer.exact(kLight.sampled, sample ? 1 : 0);
    if (sample) {
        const dvec3 way = sample->to - sample->from;
        const double distance = glm::length(way);
        answer.vector(kLight.origin, sample->from);
        answer.vector(kLight.direction, way / distance);
        if (distance < kFar) {
            answer.number(kLight.distance, distance);
        }
        answer.vector(kLight.contribution, sample->contribution);
    }
    return answer;
}

void compareSampleLights(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SampleLightsArguments>();
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, Observed::kWhole);
    const auto paths = stage.seen.before<shared::CameraPath>(args.paths, args.count); // none: a point per thread
    const auto rays = stage.seen.after<shared::Ray>(args.shadowRays, args.count);
    const auto contributions = stage.seen.after<glm::vec3>(args.contributions, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[paths.empty() ? i : paths[i].pixel];
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
                reference::VisiblePoint x = stage.sides.toTwin(point, nudge);
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
            [&] { return visibleInputs(point); });
    }
}

} // namespace

const Check kSampleLights{
    .kernel = "sample_lights", .compare = compareSampleLights, .fields = {kLight.all()}, .runs = kRunsTextures};

} // namespace hyalite::parity
