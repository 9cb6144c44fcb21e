// Lambertian surface: reflects `color` of the light, with equal radiance in all directions.
#ifndef HYALITE_DIFFUSE_GLSL
#define HYALITE_DIFFUSE_GLSL
#include "bsdf/parts.glsl"

uint diffuseFlags(MaterialRecord material) {
    return kBsdfDiffuse;
}

vec3 diffuseAlbedo(MaterialRecord material) {
    return material.color;
}

float diffuseOverDiffuse(MaterialRecord material, float cosine) {
    return 1.0;
}

float diffuseMeanOverDiffuse(MaterialRecord material) {
    return 1.0;
}
#endif
