// Diffuse bounces of camera paths.
#include "parity/checks/checks.h"

#include "parity/checks/visible_points.h"
#include "parity/path_recorder.h"
#include "reference/integrators/path.h"

#include "shaders/shared/kernel_arguments.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct BounceFields : FieldSet<9> {
    const Field& goesOn = exact("goes on", kDecision);
    const Field& seed = exact("seed");
    const Field& pixel = exact("pixel");
    const Field& medium = exact("medium");
    const Field& leaves = exact("leaves");
    const Field& origin = place("origin");
    const Field& direction = angle("direction", kSampled);
    const Field& beta = vector("beta", kWeight);
    const Field& pdfW = number("pdfW", kSampled, Scale::One);
};
constexpr BounceFields kBounceFields;

void compareBouncePaths(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::BouncePathsArguments>();
    const auto paths = stage.seen.before<shared::CameraPath>(args.paths, args.count);
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, Observed::kWhole);
    const auto before = stage.seen.before<shared::uint>(args.alive, args.count);
    const auto alive = stage.seen.after<shared::uint>(args.alive, args.count);
    const auto rays = stage.seen.after<shared::Ray>(args.nextRays, args.count);
    const auto nextPaths = stage.seen.after<shared::CameraPath>(args.nextPaths, args.count);
    const Sides& sides = stage.sides;
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[paths[i].pixel];
        if (point.depth != args.depth) {
            Answer device;
            device.exact(kBounceFields.goesOn, alive[i]);
            Answer answer;
            answer.exact(kBounceFields.goesOn, before[i]);
            stage.compareExact(i, device, answer);
            continue;
        }
        const auto answerOf = [&](const std::optional<reference::NextRay>& next, std::uint32_t pixel,
                                  std::uint32_t from) {
            Answer answer;
            answer.exact(kBounceFields.goesOn, next ? 1 : 0);
            if (next) {
                answer.exact(kBounceFields.seed, next->path.samplerSeed);
                answer.exact(kBounceFields.pixel, pixel);
                answer.exact(kBounceFields.medium, sides.numberOf(next->path.media));
                answer.exact(kBounceFields.leaves, from);
                answer.vector(kBounceFields.origin, next->ray.origin);
                answer.vector(kBounceFields.direction, next->ray.direction);
                answer.vector(kBounceFields.beta, next->path.beta);
                answer.number(kBounceFields.pdfW, next->path.pdfW);
            }
            return answer;
        };
        std::optional<reference::NextRay> device;
        if (alive[i] != 0) {
            device = {sides.toTwin(rays[i]), sides.toTwin(nextPaths[i])};
        }
        stage.compare(
            i, answerOf(device, nextPaths[i].pixel, rays[i].from),
            [&](Nudge nudge) {
                reference::VisiblePoint x = sides.toTwin(point, nudge);
                x.normal = nudge.direction(x.normal);
                return answerOf(
                    reference::bouncePath(sides.world(), x, sides.toTwin(paths[i]), args.pass, nudge.shift()),
                    paths[i].pixel, point.from);
            },
            [&] { return visibleInputs(point); });
    }
}

void noteBounces(PathRecorder& recorder, const Observed& dispatch) {
    const auto args = dispatch.arguments<shared::BouncePathsArguments>();
    const auto paths = dispatch.before<shared::CameraPath>(args.paths, args.count);
    const auto before = dispatch.before<shared::uint>(args.alive, args.count);
    const auto after = dispatch.after<shared::uint>(args.alive, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        if (before[i] == 0 && after[i] != 0) {
            recorder.addBounce(args.pass, paths[i].pixel);
        }
    }
}

} // namespace

const Check kBouncePaths{.kernel = "bounce_paths",
                         .compare = compareBouncePaths,
                         .fields = {kBounceFields.all()},
                         .runs = kRunsTextures,
                         .paths = {.take = noteBounces}};

} // namespace hyalite::parity
