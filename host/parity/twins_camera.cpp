// Camera paths: their start, and where they go on from diffuse surfaces.
#include "parity/twins.h"

#include "reference/integrators/path.h"
#include "reference/lib/sampling.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <numbers>

namespace hyalite::parity {

namespace {

using glm::dvec3;

} // namespace

void compareCameraRay(const Stage& stage, std::size_t i, std::uint32_t pixel, std::uint32_t pass,
                      const shared::Ray& ray, const shared::CameraPath& path) {
    Answer device;
    device.exact("pixel", path.pixel);
    device.exact("seed", path.samplerSeed);
    device.exact("medium", path.medium);
    device.vector("beta", dvec3(path.beta));
    device.number("pdfW", double{path.pdfW});
    device.vector("origin", dvec3(ray.origin));
    device.vector("direction", dvec3(ray.direction));
    stage.compare(i, device, [&](Nudge) {
        const reference::Ray started = reference::generateCameraRay(stage.sides.world(), pixel, pass);
        const reference::CameraPath begun = reference::beginCameraPath(stage.sides.world(), pixel, pass);
        Answer answer;
        answer.exact("pixel", pixel);
        answer.exact("seed", begun.samplerSeed);
        answer.exact("medium", stage.sides.numberOf(begun.medium));
        answer.vector("beta", begun.beta);
        answer.number("pdfW", begun.pdfW);
        answer.vector("origin", started.origin);
        answer.vector("direction", started.direction);
        return answer;
    });
}

void compareGenerateCameraRays(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::GenerateCameraRaysArguments>();
    const auto rays = stage.seen.after<shared::Ray>(args.rays, args.count);
    const auto paths = stage.seen.after<shared::CameraPath>(args.paths, args.count);
    for (std::uint32_t pixel = 0; pixel < args.count; ++pixel) {
        compareCameraRay(stage, pixel, pixel, args.pass, rays[pixel], paths[pixel]);
    }
}

void compareBouncePaths(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::BouncePathsArguments>();
    const auto paths = stage.seen.before<shared::CameraPath>(args.paths, args.count);
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, SIZE_MAX / 1024);
    const auto before = stage.seen.before<shared::uint>(args.alive, args.count);
    const auto alive = stage.seen.after<shared::uint>(args.alive, args.count);
    const auto rays = stage.seen.after<shared::Ray>(args.nextRays, args.count);
    const auto nextPaths = stage.seen.after<shared::CameraPath>(args.nextPaths, args.count);
    const Sides& sides = stage.sides;
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[paths[i].pixel];
        if (point.depth != args.depth) {
            Answer device;
            device.exact("goes on", alive[i]);
            Answer answer;
            answer.exact("goes on", before[i]);
            stage.compareExact(i, device, answer);
            continue;
        }
        const auto answerOf = [&](const std::optional<reference::NextRay>& next, std::uint32_t pixel,
                                  std::uint32_t from) {
            Answer answer;
            answer.exact("goes on", next ? 1 : 0);
            if (next) {
                answer.exact("seed", next->path.samplerSeed);
                answer.exact("pixel", pixel);
                answer.exact("medium", sides.numberOf(next->path.medium));
                answer.exact("leaves", from);
                answer.vector("origin", next->ray.origin);
                answer.vector("direction", next->ray.direction);
                answer.vector("beta", next->path.beta);
                answer.number("pdfW", next->path.pdfW);
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
                reference::VisiblePoint x = sides.toTwin(point);
                x.normal = nudge.direction(x.normal);
                return answerOf(
                    reference::bouncePath(sides.world(), x, sides.toTwin(paths[i]), args.pass, nudge.shift()),
                    paths[i].pixel, point.from);
            },
            [&] {
                return OffenderInputs{{"position", describe(dvec3(point.position))},
                                      {"normal", describe(dvec3(point.normal))},
                                      {"f", describe(dvec3(point.f))},
                                      {"pixel", std::to_string(point.pixel)}};
            });
    }
}

void compareStartGatherRays(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::StartGatherRaysArguments>();
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, args.count);
    const auto rays = stage.seen.after<shared::Ray>(args.rays, args.count);
    const auto paths = stage.seen.after<shared::CameraPath>(args.paths, args.count);
    const auto alive = stage.seen.after<shared::uint>(args.alive, args.count);
    const auto answerOf = [](bool isAlive, std::uint32_t seed, const dvec3& origin, const dvec3& direction,
                             const dvec3& beta) {
        Answer answer;
        answer.exact("alive", isAlive ? 1 : 0);
        if (isAlive) {
            answer.exact("seed", seed);
            answer.vector("origin", origin);
            answer.vector("direction", direction);
            answer.vector("beta", beta);
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
                          reference::VisiblePoint x = stage.sides.toTwin(point);
                          x.normal = nudge.direction(x.normal);
                          const std::uint32_t sequence = shared::gatherSequence(x.samplerSeed);
                          const glm::dvec2 uv = reference::sampleUnitSquare(shared::pathSampler(sequence, args.pass),
                                                                            shared::kGatherDirection, nudge.shift());
                          const dvec3 direction = reference::cosineHemisphere(uv, x.normal);
                          const double c = 1 - std::clamp(glm::dot(direction, x.normal), 0.0, 1.0);
                          const double entering = x.coated ? 1 - std::pow(c, 5) : 1;
                          return answerOf(glm::dot(direction, x.geometricNormal) > 0, sequence, x.position, direction,
                                          x.f * (std::numbers::pi * entering));
                      });
    }
}

} // namespace hyalite::parity
