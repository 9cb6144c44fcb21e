// A visible point as a receiver of light: everything that does not depend on the direction of incidence, evaluated once
// per point.
#ifndef HYALITE_RECEIVER_GLSL
#define HYALITE_RECEIVER_GLSL
#include "shared/path_records.h"
#include "bsdf/bsdf.glsl"
#include "textures/texture.glsl"

struct Receiver {
    MaterialRecord material; // with its textures multiplied in
    vec3 f;                  // path throughput times the BSDF [1/sr], without the factor that depends on the direction of incidence
    bool isLayered;          // that factor is not always 1
};

// `material`: of the point, with its textures multiplied in.
Receiver receiverOf(VisiblePoint x, MaterialRecord material) {
    float cosOut = clamp(dot(x.wo, x.normal), 0.0, 1.0);
    vec3 f = x.beta * diffuseShare(material) * (overDiffuse(material, cosOut) * kInvPi / x.probability);
    return Receiver(material, f, (bsdfFlags(material) & kBsdfLayered) != 0u);
}

Receiver receiverAt(VisiblePoint x, MaterialArray materials) {
    if (x.material == kNone) {
        Receiver receiver;
        receiver.material.type = kMaterialAbsorber;
        receiver.f = vec3(1.0);
        receiver.isLayered = false;
        return receiver;
    }
    return receiverOf(x, texturedMaterial(materials.at[x.material], x.onSurface, x.uv));
}

// The factor for a direction of incidence; `cosine`: of its angle from the normal.
float incidentFactor(Receiver receiver, float cosine) {
    return overDiffuse(receiver.material, cosine);
}
#endif
