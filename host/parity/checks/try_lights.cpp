// Lights tried at places before the first pass.
#include "parity/checks/checks.h"

#include "parity/checks/light_samples.h"
#include "parity/checks/visible_points.h"

#include "shaders/shared/try_lights_arguments.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct TryFields : FieldSet<3> {
    const Field& tried = exact("tried", kGrazing);
    const Field& seen = exact("seen", kEdge);
    const Field& brought = number("brought", kWeight);
};
constexpr TryFields kTry;

Answer answerOf(std::uint32_t tried, std::uint32_t seen, double brought) {
    Answer answer;
    answer.exact(kTry.tried, tried);
    answer.exact(kTry.seen, seen);
    answer.number(kTry.brought, brought);
    return answer;
}

void compareTryLights(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::TryLightsArguments>();
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, args.places);
    const auto broughtBefore = stage.seen.before<float>(args.brought, args.count);
    const auto brought = stage.seen.after<float>(args.brought, args.count);
    const auto triesBefore = stage.seen.before<glm::uvec2>(args.tries, args.count);
    const auto tries = stage.seen.after<glm::uvec2>(args.tries, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[i % args.places];
        const glm::uvec2 added = tries[i] - triesBefore[i];
        stage.compare(
            i, answerOf(added.x, added.y, double{brought[i]}),
            [&](Nudge nudge) {
                const Answer none = answerOf(0, 0, double{broughtBefore[i]});
                if (point.depth == 0 || point.depth != args.depth) {
                    return none;
                }
                reference::VisiblePoint x = stage.sides.toTwin(point, nudge);
                x.position = nudge.point(x.position, stage.sides.scale());
                x.shadowOrigin = x.position;
                x.normal = nudge.direction(x.normal);
                const auto light = static_cast<std::uint32_t>(i / args.places);
                const auto sample = reference::sampleLight(stage.sides.world(), x, args.pass, light, nudge.shift());
                if (!sample || sample->contribution == dvec3(0)) {
                    return none;
                }
                const bool seen = isUnoccluded(stage.sides, *sample, point.from);
                const dvec3& c = sample->contribution;
                return answerOf(1, seen ? 1 : 0, double{broughtBefore[i]} + (seen ? (c.x + c.y + c.z) / 3 : 0));
            },
            [&] { return visibleInputs(point); });
    }
}

} // namespace

const Check kTryLights{
    .kernel = "try_lights", .compare = compareTryLights, .fields = {kTry.all()}, .runs = kRunsTextures};

} // namespace hyalite::parity
