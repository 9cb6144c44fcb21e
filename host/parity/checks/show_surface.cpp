// Normals or distances in place of radiance.
#include "parity/checks/checks.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct ShownFields : FieldSet<2> {
    const Field& normal = vector("normal", kNormal, Scale::One);
    const Field& depth = vector("depth", kSame);
};
constexpr ShownFields kShown;

void compareShowSurface(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::ShowSurfaceArguments>();
    const auto rays = stage.seen.before<shared::Ray>(args.rays, args.count);
    const auto hits = stage.seen.before<shared::Hit>(args.hits, args.count);
    const auto colors = stage.seen.after<glm::vec3>(args.colors, args.count);
    const Field& field = args.shown == shared::kShowDepth ? kShown.depth : kShown.normal;
    for (std::size_t i = 0; i < args.count; ++i) {
        const bool isHit = hits[i].object != shared::kNone;
        Answer device;
        device.vector(field, dvec3(colors[i]));
        stage.compare(i, device, [&](Nudge nudge) {
            Answer answer;
            if (args.shown == shared::kShowDepth) {
                answer.vector(field, dvec3(isHit ? double{hits[i].t} : 0));
                return answer;
            }
            reference::Ray ray = stage.sides.toTwin(rays[i]);
            auto hit = stage.sides.refined(ray, rays[i].from, hits[i]);
            ray.direction = nudge.direction(ray.direction);
            answer.vector(field, hit ? 0.5 + 0.5 * reference::evaluateSurface(stage.sides.world(), ray, *hit).normal
                                     : dvec3(0));
            return answer;
        });
    }
}

} // namespace

const Check kShowSurface{.kernel = "show_surface", .compare = compareShowSurface, .fields = {kShown.all()}};

} // namespace hyalite::parity
