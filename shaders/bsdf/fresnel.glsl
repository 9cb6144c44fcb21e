// Fresnel's equations for conductors, and Schlick's approximation. For dielectrics: interface.glsl.
#ifndef HYALITE_FRESNEL_GLSL
#define HYALITE_FRESNEL_GLSL
#include "lib/math.glsl"

// (1 - cosine)^5, for Schlick's approximation.
float schlickPower(float cosine) {
    float c = clamp(1.0 - cosine, 0.0, 1.0);
    return c * c * c * c * c;
}

// Fresnel's equations for the complex index eta + i k, unpolarised light.
vec3 fresnelConductor(float cosine, vec3 eta, vec3 k) {
    float cos2 = cosine * cosine;
    float sin2 = 1.0 - cos2;
    vec3 real = eta * eta - k * k - sin2; // real part of the squared index minus sin^2; its square root is a + i b
    vec3 sum = sqrt(real * real + 4.0 * eta * eta * k * k);
    vec3 a = sqrt(max(vec3(0.0), 0.5 * (sum + real)));
    vec3 s = sum + cos2;
    vec3 t = 2.0 * cosine * a;
    vec3 perpendicular = (s - t) / max(s + t, vec3(kTiny));
    vec3 p = cos2 * sum + sin2 * sin2;
    vec3 q = t * sin2;
    vec3 parallel = perpendicular * ((p - q) / max(p + q, vec3(kTiny)));
    return 0.5 * (perpendicular + parallel);
}
#endif
