#version 460
#extension GL_GOOGLE_include_directive : require
// Estimates the picture's Monte Carlo error. The n and m passes of the two camera sequences have independent means A
// and B. With variances V / n and V / m, (A - B)^2 estimates V (n + m) / (n m), so (A - B)^2 n m / (n + m)^2 estimates
// the variance of the mean over all passes, V / (n + m). Where light was sought in vain so far nothing is known: such a
// pixel counts with a standard error as large as the floor of the relative error.
// reads: sums over the passes of each camera sequence, marks of the pixels where light was sought
// writes: standard errors, sums of their squares, counts of black pixels
// threads: pixels / 64
// computes: (A − B)² n m / (n + m)²
#include "shared/kernel_arguments.h"
#include "film/film.glsl"
#include "lib/thread.glsl"

const float kDarkFloor = 0.01; // keeps black pixels from dominating, as in relMSE [(W/(m^2 sr))^2]

layout(push_constant, scalar) uniform Push { EstimateErrorArguments args; };

void main() {
    uint thread = threadIndex();
    uint threads = (args.count + kErrorChunk - 1u) / kErrorChunk;
    if (thread >= threads) {
        return;
    }
    float passes = args.firstPasses + args.secondPasses;
    float weight = sqrt(args.firstPasses * args.secondPasses) / passes;
    float sum = 0.0;
    uvec2 dark = uvec2(0u);
    for (uint i = thread; i < args.count; i += threads) { // neighbouring threads read neighbouring pixels
        vec3 first = vec3(0.0);
        vec3 second = vec3(0.0);
        for (uint layer = 0u; layer < args.layers; ++layer) {
            if ((args.light >> layer & 1u) != 0u) {
                first += filmColor(args.first.at[layer * args.count + i]);
                second += filmColor(args.second.at[layer * args.count + i]);
            }
        }
        vec3 mean = (first + second) / passes;
        vec3 error = weight * abs(first / args.firstPasses - second / args.secondPasses);
        if (all(equal(mean, vec3(0.0)))) {
            bool sought = args.sought.at[i] != 0u;
            dark += uvec2(1u, sought ? 1u : 0u);
            error = vec3(sought ? sqrt(kDarkFloor) : 0.0);
        }
        args.errors.at[i] = error;
        vec3 relative = error * error / (mean * mean + kDarkFloor);
        sum += relative.x + relative.y + relative.z;
    }
    args.sums.at[thread] = sum;
    args.dark.at[thread] = dark;
}
