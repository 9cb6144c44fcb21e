// The start of camera paths.
#include "parity/checks/checks.h"

#include "geometry/light_use.h"
#include "parity/checks/camera_ray.h"
#include "parity/path_recorder.h"

#include "shaders/shared/kernel_arguments.h"

namespace hyalite::parity {

namespace {

void compareGenerateCameraRays(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::GenerateCameraRaysArguments>();
    const auto rays = stage.seen.after<shared::Ray>(args.rays, args.count);
    const auto paths = stage.seen.after<shared::CameraPath>(args.paths, args.count);
    reference::CameraFrame camera = stage.sides.world().camera;
    camera.width = args.camera.width;
    camera.height = args.camera.height;
    for (std::uint32_t pixel = 0; pixel < args.count; ++pixel) {
        compareCameraRay(stage, camera, pixel, pixel, args.pass, rays[pixel], paths[pixel]);
    }
}

// Paths on which lights are tried are no part of the picture.
void beginPass(PathRecorder& recorder, const Observed& seen) {
    if (seen.arguments<shared::GenerateCameraRaysArguments>().pass == kLearningPass) {
        recorder.leaveCamera();
    } else {
        recorder.beginCameraPass();
    }
}

} // namespace

using glm::dvec3;

void compareCameraRay(const Stage& stage, const reference::CameraFrame& camera, std::size_t i, std::uint32_t pixel,
                      std::uint32_t pass, const shared::Ray& ray, const shared::CameraPath& path) {
    Answer device;
    device.exact(kCameraRay.pixel, path.pixel);
    device.exact(kCameraRay.seed, path.samplerSeed);
    device.exact(kCameraRay.medium, path.media);
    device.vector(kCameraRay.beta, dvec3(path.beta));
    device.number(kCameraRay.pdfW, double{path.pdfW});
    device.vector(kCameraRay.origin, dvec3(ray.origin));
    device.vector(kCameraRay.direction, dvec3(ray.direction));
    stage.compare(i, device, [&](Nudge) {
        const reference::World& world = stage.sides.world();
        const reference::Ray started = reference::generateCameraRay(camera, world.render, pixel, pass);
        const reference::CameraPath begun = reference::beginCameraPath(world, pixel, pass);
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

const Check kGenerateCameraRays{.kernel = "generate_camera_rays",
                                .compare = compareGenerateCameraRays,
                                .fields = {kCameraRay.all()},
                                .paths = {.begins = true, .take = beginPass}};

} // namespace hyalite::parity
