// The list of BSDF models, shared by the kernels, the reference and the host. A new model is a number, the fields that
// it reads, its rows in the lists and its file; besides this file it is shaders/bsdf/NAME.glsl,
// host/reference/bsdf/NAME.cpp and host/kinds/materials/NAME.cpp.
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
SHARED_CONSTANT kMaterialRough = 31u; // not a model: set if the scene has a rough lobe

// All models.
#define HYALITE_MODELS(ROW)                                                                                            \
    ROW(Diffuse, diffuse)                                                                                              \
    ROW(Mirror, mirror)                                                                                                \
    ROW(Dielectric, dielectric)                                                                                        \
    ROW(Conductor, conductor)                                                                                          \
    ROW(MetallicRoughness, metallicRoughness)                                                                          \
    ROW(Custom, custom)                                                                                                \
    ROW(ClearCoat, clearCoat)

// Models with a diffuse part: their GLSL has NAMEAlbedo, NAMEOverDiffuse and NAMEMeanOverDiffuse.
#define HYALITE_DIFFUSE_MODELS(ROW)                                                                                    \
    ROW(Diffuse, diffuse)                                                                                              \
    ROW(MetallicRoughness, metallicRoughness)                                                                          \
    ROW(ClearCoat, clearCoat)

// Models with a lobe: their GLSL has NAMELobe and NAMEReflectance.
#define HYALITE_LOBE_MODELS(ROW)                                                                                       \
    ROW(Mirror, mirror)                                                                                                \
    ROW(Dielectric, dielectric)                                                                                        \
    ROW(Conductor, conductor)                                                                                          \
    ROW(MetallicRoughness, metallicRoughness)                                                                          \
    ROW(Custom, custom)                                                                                                \
    ROW(ClearCoat, clearCoat)

// Models with a second lobe, a coat over the rest: their GLSL has NAMECoat and NAMEOverLobe.
#define HYALITE_COATED_MODELS(ROW) ROW(ClearCoat, clearCoat)

// Scattering types of a surface for light that arrives on one side.
SHARED_CONSTANT kBsdfDiffuse = 1u;  // reflects light into all directions; photons are stored and gathered there
SHARED_CONSTANT kBsdfGlossy = 2u;   // has a lobe with a density
SHARED_CONSTANT kBsdfSpecular = 4u; // has a lobe without a density, as a mirror
SHARED_CONSTANT kBsdfTransmitting = 8u;
SHARED_CONSTANT kBsdfLayered = 16u; // a layer over the diffuse part: the transmitted light depends on the direction

// The parameters of all models; each model reads its own. Floats on the device, doubles in a Scene.
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
    Color absorption; // dielectric: coefficient inside [1/m]
    Scalar ior;       // dielectric: index inside over that of the medium around, > 0; with a priority, over vacuum's
    Scalar roughness; // 0: smooth; else the alpha of the GGX distribution is its square
    Scalar metallic;  // metallic-roughness, clear coat: 0 dielectric, 1 metal
    Scalar coat;      // clear coat: share of the surface that it covers, [0, 1]
    Scalar coatRoughness;  // likewise: as roughness, of the coat
    Scalar coatIor;        // likewise: index of the coat over that outside, >= 1
    Vector4 parameters;    // custom: parameters of its function
    uint priority;         // dielectric: of its volume over others, 1 …; 0: none, it is nested where it is entered
    uint thin;             // dielectric: 1: both faces of a pane at once
    uint function;         // custom: number of its function among the scene's
    uint colorTexture;     // multiplies `color`; kNone: none
    uint roughnessTexture; // green multiplies roughness, blue metallic; kNone: none
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

// Only bsdf.glsl includes the models themselves.
#ifdef HYALITE_BSDF_MODELS
#include "bsdf/clear_coat.glsl"
#include "bsdf/conductor.glsl"
#include "bsdf/custom.glsl"
#include "bsdf/dielectric.glsl"
#include "bsdf/diffuse.glsl"
#include "bsdf/metallic_roughness.glsl"
#include "bsdf/mirror.glsl"
#endif
