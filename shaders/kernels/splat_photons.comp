#version 460
#extension GL_GOOGLE_include_directive : require
// Draws photons as points: counts each photon that is visible to the camera in the pixel it projects to.
// reads: photons, tables
// writes: photons per pixel and kind
// threads: photons
// computes: projection onto the image, occluded points left out
#include "shared/kernel_arguments.h"
#include "photons/photon.glsl"
#include "shapes/scene.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { SplatPhotonsArguments args; };

// A hit closer than this share of the point's distance occludes it; the point's own surface does not.
const float kNear = 0.999;

void main() {
    uint i = threadIndex();
    if (i >= args.count || args.photons.at[i].surface == kNone) {
        return;
    }
    Photon photon = args.photons.at[i];
    CameraRecord camera = args.camera;
    vec3 way = photon.position - camera.position;
    float depth = dot(way, camera.forward);
    if (depth <= 0.0) {
        return;
    }
    vec2 image = vec2(dot(way, camera.right) / dot(camera.right, camera.right),
                      dot(way, camera.up) / dot(camera.up, camera.up)) / depth;
    vec2 raster = (image - vec2(-1.0, 1.0)) * vec2(0.5, -0.5) * vec2(camera.width, camera.height);
    if (raster.x < 0.0 || raster.y < 0.0 || raster.x >= float(camera.width) || raster.y >= float(camera.height)) {
        return;
    }
    float distance = length(way);
    Ray ray = Ray(camera.position, kNear * distance, way / distance, 0u);
    if (traceScene(args.rootNode, ray, true).object == kNone) {
        uint pixel = uint(raster.y) * camera.width + uint(raster.x);
        atomicAdd(args.counts.at[4u * pixel + photonKind(photon.surface)], 1u);
    }
}
