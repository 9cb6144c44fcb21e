// Final gathering: the rays that start at visible points.
#include "parity/checks/checks.h"

#include "parity/path_recorder.h"
#include "reference/lib/sampling.h"
#include "reference/lights/receiver.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <numbers>

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct GatherRayFields : FieldSet<5> {
    const Field& alive = exact("alive", kGrazing);
    const Field& seed = exact("seed");
    const Field& origin = place("origin");
    const Field& direction = angle("direction", kSampled);
    const Field& beta = vector("beta", kWeight);
};
constexpr GatherRayFields kGatherRay;

void compareStartGatherRays(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::StartGatherRaysArguments>();
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, args.count);
    const auto rays = stage.seen.after<shared::Ray>(args.rays, args.count);
    const auto paths = stage.seen.after<shared::CameraPath>(args.paths, args.count);
    const auto alive = stage.seen.after<shared::uint>(args.alive, args.count);
    const auto answerOf = [](bool isAlive, std::uint32_t seed, const dvec3& origin, const dvec3& direction,
                             const dvec3& beta) {
        Answer answer;
        answer.exact(kGatherRay.alive, isAlive ? 1 : 0);
        if (isAlive) {
            answer.exact(kGatherRay.seed, seed);
            answer.vector(kGatherRay.origin, origin);
            answer.vector(kGatherRay.direction, direction);
            answer.vector(kGatherRay.beta, beta);
        }
        return answer;
    };
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[i];
        stage.compare(i,
                      answerOf(alive[i] != 0, paths[i].samplerSeed, dvec3(rays[i].origin), dvec3(rays[i].direction),
                               dvec3(paths[i].beta)),
                      [&](Nudge nudge) {
                          if (point.depth == 0) {
                              return answerOf(false, 0, {}, {}, {});
                          }
                          reference::VisiblePoint x = stage.sides.toTwin(point, nudge);
                          x.normal = nudge.direction(x.normal);
                          const std::uint32_t sequence = shared::gatherSequence(x.samplerSeed);
                          const glm::dvec2 uv = reference::sampleUnitSquare(shared::pathSampler(sequence, args.pass),
                                                                            shared::kGatherDirection, nudge.shift());
                          const dvec3 direction = reference::cosineHemisphere(uv, x.normal);
                          const reference::Receiver receiver = reference::receiverAt(x);
                          const double incident = receiver.incident(glm::dot(direction, x.normal));
                          return answerOf(glm::dot(direction, x.geometricNormal) > 0, sequence, x.position, direction,
                                          receiver.f * (std::numbers::pi * incident));
                      });
    }
}

} // namespace

const Check kStartGatherRays{
    .kernel = "start_gather_rays",
    .compare = compareStartGatherRays,
    .fields = {kGatherRay.all()},
    .runs = kRunsTextures,
    .paths = {.take = [](PathRecorder& recorder, const Observed&) { recorder.leaveCamera(); }}};

} // namespace hyalite::parity
