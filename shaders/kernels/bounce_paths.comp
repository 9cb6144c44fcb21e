#version 460
#extension GL_GOOGLE_include_directive : require
// Path tracing: continues paths at diffuse surfaces in cosine-distributed directions. Russian roulette ends paths in
// proportion to the throughput they still carry [Arvo90].
// reads: visible points, camera paths
// writes: next rays and paths, alive flags
// threads: camera paths
// computes: cosine-distributed bounce: β f π; roulette p = max β [Arvo90]
#include "shared/kernel_arguments.h"
#include "lights/receiver.glsl"
#include "lib/sampling.glsl"
#include "lib/queue.glsl"

layout(push_constant, scalar) uniform Push { BouncePathsArguments args; };

void main() {
    uint id = threadIndex();
    if (id >= liveCount(args.live, args.count) || args.depth >= args.maxDepth) {
        return;
    }
    CameraPath path = args.paths.at[id];
    VisiblePoint x = args.visiblePoints.at[path.pixel];
    if (x.depth != args.depth) {
        return; // the path left by a lobe or has ended
    }
    uint vertex = x.depth - 1u;
    Sampler numbers = pathSampler(x.samplerSeed, args.pass);
    vec3 direction = cosineHemisphere(sampleUnit(numbers, pathBounce(vertex)), x.normal);
    if (dot(direction, unpackDirection(x.geometricNormal, 16u)) <= 0.0) {
        return; // the smoothed normal tilts below the geometric surface: this direction leads into it
    }
    float cosine = max(0.0, dot(direction, x.normal));
    Receiver receiver = receiverAt(x, args.materials);
    vec3 beta = receiver.f * (kPi * incidentFactor(receiver, cosine)); // f cos / (cos / pi)
    float survival = min(1.0, maxComponent(beta));
    if (sampleUnit(numbers, pathRoulette(vertex)).x >= survival) {
        return;
    }
    args.nextRays.at[id] = Ray(x.position, kInfinity, direction, x.from);
    args.nextPaths.at[id] = CameraPath(beta / survival, path.pixel, x.samplerSeed, path.media, cosine * kInvPi);
    args.alive.at[id] = 1u;
}
