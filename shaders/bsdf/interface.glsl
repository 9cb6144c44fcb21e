// Reflection and refraction at a smooth surface. Directions d travel with the light or the ray, towards the surface; n
// is unit and on the side that d comes from.
#ifndef HYALITE_INTERFACE_GLSL
#define HYALITE_INTERFACE_GLSL
#include "shared/language.h"

// R = I - 2 (N . I) N [Whitted80]
vec3 reflected(vec3 d, vec3 n) {
    return d - 2.0 * dot(n, d) * n;
}

struct Interface {
    float reflectance; // F, unpolarised; 1: total internal reflection
    float cosTransmitted;
    float eta;         // index of the incident side over that of the other side
};

// Fresnel's equations for cosIncident = -d . n >= 0.
Interface meetInterface(float cosIncident, float eta) {
    if (eta == 1.0) {
        return Interface(0.0, cosIncident, 1.0);
    }
    // 1 - eta^2 (1 - cos^2), in a form that stays accurate near grazing incidence
    float cosSquared = 1.0 - eta * eta * (1.0 - cosIncident) * (1.0 + cosIncident);
    if (cosSquared <= 0.0) {
        return Interface(1.0, 0.0, eta);
    }
    float cosTransmitted = sqrt(cosSquared);
    float s = (eta * cosIncident - cosTransmitted) / (eta * cosIncident + cosTransmitted);
    float p = (eta * cosTransmitted - cosIncident) / (eta * cosTransmitted + cosIncident);
    return Interface(0.5 * (s * s + p * p), cosTransmitted, eta);
}

// Snell's law; not for total internal reflection.
vec3 refracted(vec3 d, vec3 n, float cosIncident, Interface i) {
    return normalize(i.eta * d + (i.eta * cosIncident - i.cosTransmitted) * n);
}
#endif
