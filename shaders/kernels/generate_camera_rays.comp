#version 460
#extension GL_GOOGLE_include_directive : require
// Starts one camera path per pixel, through a point of the pixel that the pass chooses (box filter).
#include "shared/kernel_arguments.h"
#include "lib/sampling.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { GenerateCameraRaysArguments args; };

void main() {
    uint pixel = threadIndex();
    if (pixel >= args.count) {
        return;
    }
    CameraRecord camera = args.camera;
    Sampler sampler_ = cameraSampler(args.seed, args.pass, pixel);
    vec2 inPixel = sampleUnit(sampler_, kCameraPixel);
    vec2 raster = vec2(pixel % camera.width, pixel / camera.width) + inPixel;
    vec2 image = vec2(2.0, -2.0) * raster / vec2(camera.width, camera.height) + vec2(-1.0, 1.0);
    vec3 direction = normalize(camera.forward + image.x * camera.right + image.y * camera.up);
    args.rays.at[pixel] = Ray(camera.position, kInfinity, direction, 0u);
    args.paths.at[pixel] = CameraPath(vec3(1.0), pixel, sampler_.seed, kNone, 0.0);
}
