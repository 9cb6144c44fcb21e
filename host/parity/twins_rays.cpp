// Rays through the scene.
#include "parity/twins.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

Answer answerOf(const Sides& sides, const reference::Ray& ray, const std::optional<reference::Hit>& hit) {
    Answer answer;
    answer.exact("object", hit ? hit->object : shared::kNone);
    if (!hit) {
        return answer;
    }
    answer.exact("leaf", hit->leaf);
    answer.exact("primitive", hit->primitive);
    answer.number("t", hit->t);
    answer.vector("place", reference::evaluateSurface(sides.world(), ray, *hit).position); // by the hit's coordinates
    return answer;
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
            if (!nudge.movesNothing() && sides.areInOnePlace(sides.toTwin(ray), found, met)) {
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

void compareTraceClosest(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::TraceClosestArguments>();
    const auto rays = stage.seen.before<shared::Ray>(args.rays, args.count);
    const auto hits = stage.seen.after<shared::Hit>(args.hits, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        compareClosestHit(stage, i, rays[i], hits[i]);
    }
}

void compareTraceShadow(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::TraceShadowArguments>();
    const auto rays = stage.seen.before<shared::Ray>(args.shadowRays, args.count);
    const auto contributions = stage.seen.before<glm::vec3>(args.contributions, args.count);
    const auto before = stage.seen.before<glm::vec3>(args.direct, args.count);
    const auto after = stage.seen.after<glm::vec3>(args.direct, args.count);
    const Sides& sides = stage.sides;
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::Ray& ray = rays[i];
        const bool isTraced = ray.tMax > 0;
        Answer device;
        device.exact("added", after[i] != before[i] ? 1 : 0);
        device.vector("direct", dvec3(after[i]));
        stage.compare(
            i, device,
            [&](Nudge nudge) {
                bool isSeen = isTraced;
                if (isTraced) {
                    reference::Ray twin = sides.toTwin(ray);
                    twin.origin = nudge.point(twin.origin, sides.scale());
                    twin.direction = nudge.direction(twin.direction);
                    isSeen = !sides.trace(twin, ray.from);
                }
                Answer answer;
                // What adds less than a rounding leaves no trace
                answer.exact("added", isSeen && before[i] + contributions[i] != before[i] ? 1 : 0);
                answer.vector("direct", dvec3(before[i]) + (isSeen ? dvec3(contributions[i]) : dvec3(0)));
                return answer;
            },
            [&] {
                return OffenderInputs{{"origin", describe(dvec3(ray.origin))},
                                      {"direction", describe(dvec3(ray.direction))},
                                      {"tMax", describe(double{ray.tMax})},
                                      {"from", std::to_string(ray.from)}};
            });
    }
}

} // namespace hyalite::parity
