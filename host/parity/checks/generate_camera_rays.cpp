// The start of camera paths.
#include "parity/checks/checks.h"

#include "parity/checks/camera_ray.h"
#include "parity/path_recorder.h"

#include "shaders/shared/kernel_arguments.h"

namespace hyalite::parity {

namespace {

void compareGenerateCameraRays(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::GenerateCameraRaysArguments>();
    const auto rays = stage.seen.after<shared::Ray>(args.rays, args.count);
    const auto paths = stage.seen.after<shared::CameraPath>(args.paths, args.count);
    for (std::uint32_t pixel = 0; pixel < args.count; ++pixel) {
        compareCameraRay(stage, pixel, pixel, args.pass, rays[pixel], paths[pixel]);
    }
}

} // namespace

using glm::dvec3;

void compareCameraRay(const Stage& stage, std::size_t i, std::uint32_t pixel, std::uint32_t pass,
                      const shared::Ray& ray, const shared::CameraPath& path) {
    Answer device;
    device.exact(kCameraRay.pixel, path.pixel);
    device.exact(kCameraRay.seed, path.samplerSeed);
    device.exact(kCameraRay.medium, path.media);
    device.vector(kCameraRay.beta, dvec3(path.beta));
    device.number(kCameraRay.pdfW, double{path.pdfW});
    device.vector(kCameraRay.origin, dvec3(ray.origin));
    device.vector(kCameraRay.direction, dvec3(ray.direction));
    stage.compare(i, device, [&](Nudge) {
        const reference::Ray started = reference::generateCameraRay(stage.sides.world(), pixel, pass);
        const reference::CameraPath begun = reference::beginCameraPath(stage.sides.world(), pixel, pass);
        Answer answer;
        answer.exact(kCameraRay.pixel, pixel);
        answer.exact(kCameraRay.seed, begun.samplerSeed);
        answer.exact(kCameraRay.medium, stage.sides.numberOf(begun.media));
        answer.vector(kCameraRay.beta, begun.beta);
        answer.number(kCameraRay.pdfW, begun.pdfW);
        answer.vector(kCameraRay.origin, started.origin);
        answer.vector(kCameraRay.direction, started.direction);
        return answer;
    });
}

const Check kGenerateCameraRays{
    .kernel = "generate_camera_rays",
    .compare = compareGenerateCameraRays,
    .fields = {kCameraRay.all()},
    .paths = {.begins = true, .take = [](PathRecorder& recorder, const Observed&) { recorder.beginCameraPass(); }}};

} // namespace hyalite::parity
