// One level of Whitted's ray trees: hits, shading, and direct light.
#include "parity/checks/checks.h"

#include "parity/checks/camera_ray.h"
#include "parity/checks/closest_hit.h"
#include "parity/checks/light_samples.h"
#include "parity/checks/shading.h"
#include "parity/checks/visible_points.h"
#include "parity/path_recorder.h"

#include "shaders/shared/limits.h"
#include "shaders/shared/pixel_order.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct TreeFields : FieldSet<4> {
    const Field& ray = exact("ray");
    const Field& path = exact("path");
    const Field& lit = exact("lit", kEdge);
    const Field& light = vector("light", kWeight);
};
constexpr TreeFields kTree;

// Direct light at the visible point of path i, added to the emission there.
void compareLight(const AtSurface& at, const shared::TraceWhittedArguments& args, std::span<const glm::vec3> light,
                  std::size_t i) {
    const Sides& sides = at.stage.sides;
    const shared::VisiblePoint& point = at.visible[i];
    const glm::vec3& emitted = at.emitted[i];
    const glm::vec3& arrived = light[args.slots.address == 0 ? at.paths[i].pixel : i];
    const auto answerOf = [&](const dvec3& radiance, bool isLit) {
        Answer answer;
        answer.exact(kTree.lit, isLit ? 1 : 0);
        answer.vector(kTree.light, radiance);
        return answer;
    };
    at.stage.compare(
        i, answerOf(dvec3(arrived), arrived != emitted),
        [&](Nudge nudge) {
            dvec3 direct(0);
            if (point.depth != 0) {
                reference::VisiblePoint x = sides.toTwin(point, nudge);
                x.position = nudge.point(x.position, sides.scale());
                x.shadowOrigin = x.position;
                x.normal = nudge.direction(x.normal);
                for (std::uint32_t number = 0; number < args.lightCount; ++number) {
                    const auto sample = reference::sampleLight(sides.world(), x, args.pass, number, nudge.shift());
                    if (sample) {
                        direct += lightAlong(sides, *sample, point.from);
                    }
                }
            }
            // A contribution below half an ulp of the sum leaves no trace
            return answerOf(dvec3(emitted) + direct, emitted + glm::vec3(direct) != emitted);
        },
        [&] { return visibleInputs(point); });
}

void compareTraceWhitted(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::TraceWhittedArguments>();
    const AtSurface at(stage, args);
    const auto light = stage.seen.after<glm::vec3>(args.light, Observed::kWhole);
    const std::uint32_t width = args.camera.width;
    const auto slots = stage.seen.before<shared::uint>(args.slots, args.count);
    const auto rays = stage.seen.before<shared::Ray>(args.rays, Observed::kWhole);
    const auto paths = stage.seen.before<shared::CameraPath>(args.paths, Observed::kWhole);
    const auto pixels = stage.seen.after<shared::uint>(args.pixels, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        if (args.slots.address == 0) {
            const auto thread = static_cast<std::uint32_t>(i);
            const std::uint32_t pixel =
                shared::pixelOfThread(thread, thread / (shared::kTileSide * width), width, args.count);
            compareCameraRay(stage, stage.sides.world().camera, i, pixel, args.pass, at.rays[i], at.paths[i]);
        } else {
            Answer device;
            device.exact(kTree.ray, sameBits(at.rays[i], rays[slots[i]]) ? 1 : 0);
            device.exact(kTree.path, sameBits(at.paths[i], paths[slots[i]]) ? 1 : 0);
            device.exact(kCameraRay.pixel, pixels[i]);
            Answer expected;
            expected.exact(kTree.ray, 1);
            expected.exact(kTree.path, 1);
            expected.exact(kCameraRay.pixel, paths[slots[i]].pixel);
            stage.compareExact(i, device, expected);
        }
        compareClosestHit(stage, i, at.rays[i], at.hits[i]);
        at.compare(i);
        compareLight(at, args, light, i);
    }
}

void noteTree(PathRecorder& recorder, const Observed& dispatch) {
    const auto args = dispatch.arguments<shared::TraceWhittedArguments>();
    if (args.slots.address == 0) {
        recorder.beginCameraPass();
    }
    const auto rays = dispatch.after<shared::Ray>(args.keptRays, args.count);
    const auto hits = dispatch.after<shared::Hit>(args.hits, args.count);
    const auto paths = dispatch.after<shared::CameraPath>(args.keptPaths, args.count);
    const auto visible = dispatch.after<shared::VisiblePoint>(args.visiblePoints, args.count);
    const auto nextRays = dispatch.after<shared::Ray>(args.nextRays, 2 * std::size_t{args.count});
    const auto alive = dispatch.after<shared::uint>(args.alive, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        recorder.addShading({rays[i], hits[i], paths[i], visible[i], nextRays.subspan(2 * i, alive[i])},
                            args.depths % shared::kDepthsUnit, args.pass);
    }
}

} // namespace

const Check kTraceWhitted{.kernel = "trace_whitted",
                          .compare = compareTraceWhitted,
                          .fields = {kCameraRay.all(), kClosestHit.all(), kShading.all(), kTree.all()},
                          .runs = kRunsTextures | kRunsReflectances,
                          .paths = {.begins = true, .take = noteTree}};

} // namespace hyalite::parity
