// Light from beyond the scene, as an equirectangular image tells it: radiance is constant over each texel. The middle
// of the image is what is seen along -z, its upper edge is +y.
#ifndef HYALITE_ENVIRONMENT_GLSL
#define HYALITE_ENVIRONMENT_GLSL
#include "shared/scene_records.h"
#include "lib/math.glsl"

struct Choice {
    uint index;
    float rest; // x's place between this element's ends: again uniform in [0, 1]
};

// Of `count` elements from `first` on, the first whose cdf exceeds x in [0, 1).
Choice choose(CdfArray cdfs, uint first, uint count, float x) {
    uint low = first, high = first + count - 1u;
    while (low < high) {
        uint middle = (low + high) / 2u;
        if (x < cdfs.at[middle]) {
            high = middle;
        } else {
            low = middle + 1u;
        }
    }
    float before = low > first ? cdfs.at[low - 1u] : 0.0;
    return Choice(low - first, (x - before) / (cdfs.at[low] - before));
}

vec3 environmentRadiance(LightRecord light, vec3 direction) {
    float around = turnsOf(-direction.x, direction.z) + light.rotation;
    float down = 2.0 * turnsOf(length(direction.xz), direction.y);
    uint column = min(uint((around - floor(around)) * float(light.columns)), light.columns - 1u);
    uint row = min(uint(down * float(light.rows)), light.rows - 1u);
    return light.texels.at[row * light.columns + column];
}

// A texel with a probability in proportion to the mean of its channels times its solid angle, then any direction of it:
// pdfW is in proportion to that mean.
vec3 sampleEnvironment(LightRecord light, vec2 u) {
    Choice row = choose(light.cdfs, 0u, light.rows, u.y);
    Choice column = choose(light.cdfs, light.rows + row.index * light.columns, light.columns, u.x);
    float top = sinCosTurns(0.5 * float(row.index) / float(light.rows)).y;
    float bottom = sinCosTurns(0.5 * float(row.index + 1u) / float(light.rows)).y;
    float y = clamp(top + row.rest * (bottom - top), -1.0, 1.0);
    float around = (float(column.index) + column.rest) / float(light.columns) - light.rotation;
    vec2 sc = sinCosTurns(around - floor(around));
    float radius = sqrt((1.0 - y) * (1.0 + y));
    return vec3(-radius * sc.x, y, radius * sc.y);
}

// Density [1/sr] with which sampleEnvironment finds a direction of this radiance.
float environmentPdf(LightRecord light, vec3 radiance) {
    return dot(radiance, vec3(1.0)) / (4.0 * kPi * dot(light.emission, vec3(1.0)));
}
#endif
