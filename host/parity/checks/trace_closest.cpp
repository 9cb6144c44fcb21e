// The closest hit of a ray.
#include "parity/checks/checks.h"

#include "parity/checks/closest_hit.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

Answer answerOf(const Sides& sides, const reference::Ray& ray, const std::optional<reference::Hit>& hit) {
    Answer answer;
    answer.exact(kClosestHit.object, hit ? hit->object : shared::kNone);
    if (!hit) {
        return answer;
    }
    answer.exact(kClosestHit.leaf, hit->leaf);
    answer.exact(kClosestHit.primitive, hit->primitive);
    answer.number(kClosestHit.t, hit->t);
    answer.vector(kClosestHit.place,
                  reference::evaluateSurface(sides.world(), ray, *hit).position); // from the hit's coordinates
    return answer;
}

void compareTraceClosest(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::TraceClosestArguments>();
    const auto rays = stage.seen.before<shared::Ray>(args.rays, args.count);
    const auto hits = stage.seen.after<shared::Hit>(args.hits, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        compareClosestHit(stage, i, rays[i], hits[i]);
    }
}

} // namespace

void compareClosestHit(const Stage& stage, std::size_t i, const shared::Ray& ray, const shared::Hit& hit) {
    const Sides& sides = stage.sides;
    const std::optional<reference::Hit> found = sides.toTwin(hit);
    const Answer device = answerOf(sides, sides.toTwin(ray), found);
    stage.compare(
        i, device,
        [&](Nudge nudge) {
            reference::Ray twin = sides.toTwin(ray);
            twin.origin = nudge.point(twin.origin, sides.scale());
            twin.direction = nudge.direction(twin.direction);
            const std::optional<reference::Hit> met = sides.trace(twin, ray.from);
            if ((!nudge.movesNothing() || sides.touch(found, met)) &&
                sides.areInOnePlace(sides.toTwin(ray), found, met)) {
                return device;
            }
            return answerOf(sides, twin, met);
        },
        [&] {
            return OffenderInputs{{"origin", describe(dvec3(ray.origin))},
                                  {"direction", describe(dvec3(ray.direction))},
                                  {"from", std::to_string(ray.from)}};
        });
}

const Check kTraceClosest{.kernel = "trace_closest", .compare = compareTraceClosest, .fields = {kClosestHit.all()}};

} // namespace hyalite::parity
