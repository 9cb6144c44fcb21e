// The list of BSDF models, for the kernels, the reference and the host alike. A new model is a number, the fields that
// it reads, its rows in the lists and its file; besides this file it is shaders/bsdf/NAME.glsl, host/reference/bsdf/
// NAME.cpp and host/kinds/materials/NAME.cpp.
#ifndef HYALITE_SHARED_MATERIALS_H
#define HYALITE_SHARED_MATERIALS_H
#include "language.h"
SHARED_BEGIN

SHARED_CONSTANT kMaterialAbsorber = 0u; // reflects nothing
SHARED_CONSTANT kMaterialDiffuse = 1u;
SHARED_CONSTANT kMaterialMirror = 2u;
SHARED_CONSTANT kMaterialDielectric = 3u;
SHARED_CONSTANT kMaterialConductor = 4u;
SHARED_CONSTANT kMaterialMetallicRoughness = 5u;
SHARED_CONSTANT kMaterialCustom = 6u;
SHARED_CONSTANT kMaterialClearCoat = 7u;
SHARED_CONSTANT kMaterialRough = 31u; // not a model: set for a scene with at least one rough lobe

// Every model.
#define HYALITE_MODELS(ROW)                                                                                            \
    ROW(Diffuse, diffuse)                                                                                              \
    ROW(Mirror, mirror)                                                                                                \
    ROW(Dielectric, dielectric)                                                                                        \
    ROW(Conductor, conductor)                                                                                          \
    ROW(MetallicRoughness, metallicRoughness)                                                                          \
    ROW(Custom, custom)                                                                                                \
    ROW(ClearCoat, clearCoat)

// Those with a diffuse part: their GLSL has NAMEAlbedo, NAMEOverDiffuse and NAMEMeanOverDiffuse.
#define HYALITE_DIFFUSE_MODELS(ROW)                                                                                    \
    ROW(Diffuse, diffuse)                                                                                              \
    ROW(MetallicRoughness, metallicRoughness)                                                                          \
    ROW(ClearCoat, clearCoat)

// Those with a lobe: their GLSL has NAMELobe and NAMEReflectance.
#define HYALITE_LOBE_MODELS(ROW)                                                                                       \
    ROW(Mirror, mirror)                                                                                                \
    ROW(Dielectric, dielectric)                                                                                        \
    ROW(Conductor, conductor)                                                                                          \
    ROW(MetallicRoughness, metallicRoughness)                                                                          \
    ROW(Custom, custom)                                                                                                \
    ROW(ClearCoat, clearCoat)

// Of the latter, those with a second lobe, a coat over the rest: their GLSL has NAMECoat and NAMEOverLobe.
#define HYALITE_COATED_MODELS(ROW) ROW(ClearCoat, clearCoat)

// What a surface may do with light that arrives on one side.
SHARED_CONSTANT kBsdfDiffuse = 1u;  // reflects it into all directions; photons are stored and gathered there
SHARED_CONSTANT kBsdfGlossy = 2u;   // has a lobe with a density
SHARED_CONSTANT kBsdfSpecular = 4u; // has a lobe without one: a mirror's
SHARED_CONSTANT kBsdfTransmitting = 8u;
SHARED_CONSTANT kBsdfLayered = 16u; // what reaches the diffuse part depends on the direction: something lies over it

// The parameters of all models, each of which reads its own: floats on the device, doubles in a Scene.
#ifdef __cplusplus
template <class Scalar, class Color, class Vector4>
struct MaterialFields {
#else
#define Scalar float
#define Color vec3
#define Vector4 vec4
struct MaterialRecord {
#endif
    uint type;   // kMaterial…
    Color color; // diffuse: albedo; mirror: reflectance; metallic-roughness, clear coat: base colour; each in [0, 1]
    Color eta;   // conductor: index of refraction, real part
    Color k;     // conductor: likewise, imaginary part
    Color absorption;      // dielectric: coefficient inside [1/m]
    Scalar ior;            // dielectric: index inside over outside, > 0
    Scalar roughness;      // 0: smooth; else the alpha of the GGX distribution is its square
    Scalar metallic;       // metallic-roughness, clear coat: 0 dielectric, 1 metal
    Scalar coat;           // clear coat: share of the surface that it covers, [0, 1]
    Scalar coatRoughness;  // likewise: as roughness, of the coat
    Scalar coatIor;        // likewise: index of the coat over that outside, >= 1
    Vector4 parameters;    // custom: of its function
    uint function;         // custom: number of its function among the scene's
    uint colorTexture;     // multiplies `color`; kNone: none
    uint roughnessTexture; // of those: green times roughness, blue times metallic; kNone: none
};
#ifdef __cplusplus
using MaterialRecord = MaterialFields<float, vec3, vec4>;
#else
#undef Scalar
#undef Color
#undef Vector4
#endif
DEVICE_ARRAY(MaterialRecord, MaterialArray);

SHARED_END
#endif

// bsdf.glsl asks for the models themselves.
#ifdef HYALITE_BSDF_MODELS
#include "bsdf/clear_coat.glsl"
#include "bsdf/conductor.glsl"
#include "bsdf/custom.glsl"
#include "bsdf/dielectric.glsl"
#include "bsdf/diffuse.glsl"
#include "bsdf/metallic_roughness.glsl"
#include "bsdf/mirror.glsl"
#endif
