// Where camera paths start.
#ifndef HYALITE_CAMERA_RAY_GLSL
#define HYALITE_CAMERA_RAY_GLSL
#include "shared/limits.h"
#include "shared/path_records.h"
#include "lib/math.glsl"
#include "shapes/quotient.glsl"
#include "lib/sampling.glsl"

// A path and its next ray.
struct NextRay {
    Ray ray;
    CameraPath path;
};

// Starts a camera path through a point of the pixel and a point of the lens that the pass picks. Box filter over the
// pixel; thin lens: light from a point of the plane in focus reaches the same image point through any point of the
// lens.
NextRay startAtCamera(CameraRecord camera, RenderSeed seed, uint pass, uint pixel) {
    Sampler sampler_ = cameraSampler(seed, pass, pixel);
    vec2 inPixel = sampleUnit(sampler_, kCameraPixel);
    uint row = quotient(pixel, camera.width);
    vec2 raster = vec2(pixel - row * camera.width, row) + inPixel;
    vec2 image = vec2(2.0, -2.0) * raster / vec2(camera.width, camera.height) + vec2(-1.0, 1.0);
    vec3 direction = camera.forward + image.x * camera.right + image.y * camera.up;
    vec3 onLens = vec3(0.0);
    if (camera.lensRadius > 0.0) {
        vec2 place = camera.lensRadius * concentricDisc(sampleUnit(sampler_, kCameraLens));
        onLens = place.x * normalize(camera.right) + place.y * normalize(camera.up);
        direction -= onLens / camera.focusDistance;
    }
    return NextRay(Ray(camera.position + onLens, kInfinity, normalize(direction), 0u),
                   CameraPath(vec3(1.0), pixel, sampler_.seed, camera.media, 0.0));
}
#endif
