// Shadow rays replaced by nearby shadow photons [JensenChristensen95].
#include "parity/checks/checks.h"

#include "parity/checks/photon_map_of.h"
#include "reference/photons/shadow_photons.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct VisibilityFields : FieldSet<2> {
    const Field& lit = exact("lit", kRim);
    const Field& shadowed = exact("shadowed", kRim);
};
constexpr VisibilityFields kVisibility;

struct SkipFields : FieldSet<3> {
    const Field& traced = exact("traced");
    const Field& count = exact("count");
    const Field& direct = vector("direct", kRounding);
};
constexpr SkipFields kSkip;

void compareClassifyVisibility(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::ClassifyVisibilityArguments>();
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, args.count);
    const auto lit = stage.seen.after<shared::uint>(args.lit, args.count);
    const auto shadowed = stage.seen.after<shared::uint>(args.shadowed, args.count);
    const reference::PhotonMap map = mapOf(stage, args.map.base, args.map.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[i];
        Answer device;
        device.exact(kVisibility.lit, lit[i]);
        device.exact(kVisibility.shadowed, shadowed[i]);
        stage.compare(
            i, device,
            [&](Nudge nudge) {
                reference::Visibility visibility;
                if (point.depth != 0) {
                    const double radius = nudge.number(double{args.radius});
                    visibility = reference::classifyVisibility(map, nudged(stage, point, nudge), args.lightCount,
                                                               args.agreeing, radius, double{args.surfaceError});
                }
                Answer answer;
                answer.exact(kVisibility.lit, visibility.lit);
                answer.exact(kVisibility.shadowed, visibility.shadowed);
                return answer;
            },
            [&] { return visibleInputs(point); });
    }
}

void compareSkipShadowRays(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SkipShadowRaysArguments>();
    const auto lit = stage.seen.before<shared::uint>(args.lit, args.count);
    const auto shadowed = stage.seen.before<shared::uint>(args.shadowed, args.count);
    const auto raysBefore = stage.seen.before<shared::Ray>(args.shadowRays, args.count);
    const auto rays = stage.seen.after<shared::Ray>(args.shadowRays, args.count);
    const auto contributions = stage.seen.before<glm::vec3>(args.contributions, args.count);
    const auto directBefore = stage.seen.before<glm::vec3>(args.direct, args.count);
    const auto direct = stage.seen.after<glm::vec3>(args.direct, args.count);
    std::uint32_t spared = 0;
    for (std::size_t i = 0; i < args.count; ++i) {
        const bool isRay = raysBefore[i].tMax > 0;
        const bool isLit = (lit[i] >> args.light & 1U) != 0;
        const bool isKnown = isLit || (shadowed[i] >> args.light & 1U) != 0;
        spared += isRay && isKnown ? 1 : 0;
        Answer device;
        device.exact(kSkip.traced, rays[i].tMax > 0 ? 1 : 0);
        device.vector(kSkip.direct, dvec3(direct[i]));
        Answer answer;
        answer.exact(kSkip.traced, isRay && !isKnown ? 1 : 0);
        answer.vector(kSkip.direct, dvec3(directBefore[i]) + (isRay && isLit ? dvec3(contributions[i]) : dvec3(0)));
        stage.compareExact(i, device, answer);
    }
    Answer device;
    device.exact(kSkip.count, stage.seen.after<shared::uint>(args.raysSaved, 1)[0] -
                                  stage.seen.before<shared::uint>(args.raysSaved, 1)[0]);
    Answer answer;
    answer.exact(kSkip.count, spared);
    stage.compareExact(args.count, device, answer);
}

} // namespace

const Check kClassifyVisibility{
    .kernel = "classify_visibility", .compare = compareClassifyVisibility, .fields = {kVisibility.all()}};
const Check kSkipShadowRays{.kernel = "skip_shadow_rays", .compare = compareSkipShadowRays, .fields = {kSkip.all()}};

} // namespace hyalite::parity
