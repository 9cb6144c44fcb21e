// Direct light at rough surfaces.
#include "parity/checks/checks.h"

#include "parity/checks/light_samples.h"

#include "shaders/shared/kernel_arguments.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct RoughLightFields : FieldSet<2> {
    const Field& added = exact("added", kEdge);
    const Field& direct = vector("direct", kDensity);
};
constexpr RoughLightFields kRoughLight;

// Light below this fraction of what a lobe of 1/sr would reflect counts as none.
constexpr double kNothing = 0x1p-16;

void compareSampleRoughLights(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SampleRoughLightsArguments>();
    const auto points = stage.seen.before<shared::RoughPoint>(args.roughPoints, args.count);
    const std::size_t all = Observed::kWhole;
    const auto before = stage.seen.before<glm::vec3>(args.direct, all);
    const auto after = stage.seen.after<glm::vec3>(args.direct, all);
    const Sides& sides = stage.sides;
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::RoughPoint& point = points[i];
        if (point.depth == 0) {
            continue;
        }
        // Where a lobe reflects almost nothing, its value is a difference of numbers close to 1
        const auto arrival = reference::sampleArrival(
            sides.world(), dvec3(point.position),
            {.depth = point.depth, .samplerSeed = point.samplerSeed, .pass = args.pass, .light = lightOf(args.light)});
        const double nothing = kNothing * largestComponent(dvec3(point.beta) * arrival.irradiance);
        const auto lightAdded = [&](const dvec3& added) {
            Answer answer;
            answer.exact(kRoughLight.added, largestComponent(added) > nothing ? 1 : 0);
            if (largestComponent(added) > nothing) {
                answer.vector(kRoughLight.direct, dvec3(before[point.result]) + added);
            }
            return answer;
        };
        const Answer device = lightAdded(dvec3(after[point.result]) - dvec3(before[point.result]));
        stage.compare(
            i, device,
            [&](Nudge nudge) {
                reference::RoughPoint x = sides.toTwin(point, nudge);
                x.surface.position = nudge.point(x.surface.position, sides.scale());
                x.surface.normal = nudge.direction(x.surface.normal);
                x.wo = nudge.direction(x.wo);
                const auto sample =
                    reference::sampleRoughLight(sides.world(), x, args.pass, lightOf(args.light), nudge.shift());
                dvec3 light(0);
                if (sample) {
                    const bool through = glm::dot(sample->to - sample->from, x.surface.geometricNormal) < 0;
                    light = lightAlong(sides, *sample, through ? point.from ^ shared::kRayInside : point.from);
                }
                return lightAdded(glm::vec3(before[point.result]) + glm::vec3(light) == before[point.result] ? dvec3(0)
                                                                                                             : light);
            },
            [&] {
                return OffenderInputs{{"position", describe(dvec3(point.position))},
                                      {"normal", describe(dvec3(point.normal))},
                                      {"wo", describe(dvec3(point.wo))},
                                      {"material", std::to_string(point.material)},
                                      {"result", std::to_string(point.result)}};
            });
    }
}

} // namespace

const Check kSampleRoughLights{.kernel = "sample_rough_lights",
                               .compare = compareSampleRoughLights,
                               .fields = {kRoughLight.all()},
                               .runs = kRunsTextures | kRunsReflectances};

} // namespace hyalite::parity
