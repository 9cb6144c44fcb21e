// Shadow rays: adds unoccluded light.
#include "parity/checks/checks.h"

#include "reference/lights/shadow.h"

#include "shaders/shared/kernel_arguments.h"

#include <algorithm>

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct ShadowFields : FieldSet<2> {
    const Field& added = exact("added", kEdge);
    const Field& direct = vector("direct", kRounding);
};
constexpr ShadowFields kShadow;

void compareTraceShadow(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::TraceShadowArguments>();
    const auto rays = stage.seen.before<shared::Ray>(args.shadowRays, args.count);
    const auto contributions = stage.seen.before<glm::vec3>(args.contributions, args.count);
    const auto paths = stage.seen.before<shared::CameraPath>(args.paths, args.count); // none: a pixel per ray
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, Observed::kWhole);
    const auto allBefore = stage.seen.before<glm::vec3>(args.direct, Observed::kWhole);
    const auto allAfter = stage.seen.after<glm::vec3>(args.direct, Observed::kWhole);
    const Sides& sides = stage.sides;
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::Ray& ray = rays[i];
        const std::size_t pixel = paths.empty() ? i : paths[i].pixel;
        const glm::vec3& before = allBefore[pixel];
        const glm::vec3& after = allAfter[pixel];
        const bool isTraced = ray.tMax > 0;
        Answer device;
        device.exact(kShadow.added, after != before ? 1 : 0);
        device.vector(kShadow.direct, dvec3(after));
        stage.compare(
            i, device,
            [&](Nudge nudge) {
                reference::Ray twin = sides.toTwin(ray);
                twin.origin = nudge.point(twin.origin, sides.scale());
                twin.direction = nudge.direction(twin.direction);
                dvec3 light(0);
                if (isTraced && (ray.from & shared::kRayPasses) != 0) {
                    const dvec3 end = twin.origin + std::min(twin.tMax, reference::kBeyond) * twin.direction;
                    light =
                        dvec3(contributions[i]) * reference::straightTransmittance(sides.world(), twin.origin, end,
                                                                                   sides.media(points[pixel].media));
                } else if (isTraced && !sides.trace(twin, ray.from)) {
                    light = dvec3(contributions[i]);
                }
                Answer answer;
                // A contribution below half an ulp of the sum leaves no trace
                answer.exact(kShadow.added, before + glm::vec3(light) != before ? 1 : 0);
                answer.vector(kShadow.direct, dvec3(before) + light);
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

} // namespace

const Check kTraceShadow{.kernel = "trace_shadow", .compare = compareTraceShadow, .fields = {kShadow.all()}};

} // namespace hyalite::parity
