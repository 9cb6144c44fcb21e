// The isotropic GGX distribution of microfacets with Smith's masking [Walter07], [Heitz14]. Vectors are unit, in a frame
// whose z axis is the surface's normal; `alpha` is the roughness of the distribution.
#ifndef HYALITE_GGX_GLSL
#define HYALITE_GGX_GLSL
#include "lib/math.glsl"

// D(m) [1/sr], written in terms of the tangent, which stays accurate for small alpha.
float ggxDistribution(vec3 m, float alpha) {
    float t = dot(m.xy, m.xy) / (alpha * alpha) + m.z * m.z;
    return 1.0 / (kPi * alpha * alpha * t * t);
}

// Smith's Lambda: a direction sees the share 1 / (1 + Lambda) of the facets that face it.
float smithLambda(vec3 w, float alpha) {
    float cosine = abs(w.z);
    float slant = sqrt(cosine * cosine + alpha * alpha * dot(w.xy, w.xy));
    return 0.5 * (slant / max(cosine, kTiny) - 1.0);
}

// Samples a normal visible from wo, with density max(0, wo . m) D(m) / ((1 + Lambda(wo)) wo.z): once the surface is
// stretched to a hemisphere, the mirror directions of wo cover a cap of the sphere uniformly [Dupuy23].
vec3 sampleVisibleNormal(vec3 wo, float alpha, vec2 u) {
    vec3 stretched = normalize(vec3(alpha * wo.xy, wo.z));
    float below = u.y * (1.0 + stretched.z); // 1 - z of the mirrored direction
    float radius = sqrt(max(0.0, below * (2.0 - below)));
    vec2 sc = sinCosTurns(u.x);
    vec3 h = vec3(radius * sc.y, radius * sc.x, 1.0 - below) + stretched;
    return normalize(vec3(alpha * h.xy, max(h.z, kTiny)));
}
#endif
