#version 460
#extension GL_GOOGLE_include_directive : require
// Starts one camera path per pixel.
// reads: camera
// writes: rays, camera paths
// threads: pixels
// computes: ray direction from the image point; box filter; thin lens
#include "shared/kernel_arguments.h"
#include "camera/camera_ray.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { GenerateCameraRaysArguments args; };

void main() {
    uint pixel = threadIndex();
    if (pixel < args.count) {
        NextRay start = startAtCamera(args.camera, args.seed, args.pass, pixel);
        args.rays.at[pixel] = start.ray;
        args.paths.at[pixel] = start.path;
    }
}
