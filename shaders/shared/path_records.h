// The records that kernels pass along paths, and those that the photon pass stores.
#ifndef HYALITE_SHARED_PATH_RECORDS_H
#define HYALITE_SHARED_PATH_RECORDS_H
#include "language.h"
#include "media.h"
SHARED_BEGIN

struct Ray {
    vec3 origin;    // world [m], already moved off the surface it leaves
    float tMax;     // the ray ends here; in units of |direction|
    vec3 direction; // unit
    uint from;      // 0: it leaves no object; else 1 + the object it leaves, plus kRayInside if it runs inside that
};
DEVICE_ARRAY(Ray, RayArray);

// The ray's knowledge of the object it leaves decides where rounding cannot: at an edge, a point moved off one surface
// by its error may still be on the wrong side of the other.
SHARED_CONSTANT kRayInside = 0x80000000u;
// Added to a shadow ray's `from`: it passes through thin glass and through dielectrics that do not refract it.
SHARED_CONSTANT kRayPasses = 0x40000000u;

struct Hit {
    float t;        // distance along the ray [m]
    uint object;    // kNone: nothing was hit; for a CSG object, the leaf whose surface was hit
    uint primitive; // mesh: its triangle in the geometry table; quadric: part, see kPartForm; 0 for other shapes. For
                    // CSG plus kHitEnters if the ray enters the solid
    vec2 uv;        // flat shapes: coordinates in the plane; triangle: barycentric of its second and third corner
};
DEVICE_ARRAY(Hit, HitArray);
SHARED_CONSTANT kHitEnters = 0x80000000u;

// The state of a camera path.
struct CameraPath {
    vec3 beta;        // throughput: contribution to the pixel of one unit of radiance along the present ray
    uint pixel;       // y * width + x, row 0 on top
    uint samplerSeed; // see pathSampler
    uint media;       // around the present ray, see media.h
    float pdfW;       // density of its present direction [1/sr]; 0: sampled by the lens or a specular surface, or
                      // no light was sampled where the direction was
};
DEVICE_ARRAY(CameraPath, CameraPathArray);

// A camera path's end at a diffuse surface: there photons are gathered, lights are sampled and the BSDF is evaluated
// (lights/receiver.glsl).
struct VisiblePoint {
    vec3 position; // moved off the surface to the side the path came from, world [m]
    uint depth;    // segments from the camera to here; 0: the path found no diffuse surface
    vec3 normal;   // unit, for shading, on the side the path came from
    uint samplerSeed;
    vec3 onSurface;       // the position before it was moved [m]
    uint from;            // see Ray; of a ray that stays on this side
    vec3 wo;              // unit, to where the path came from
    uint geometricNormal; // on the same side, octahedral, 16 bits a coordinate
    vec3 beta;            // path throughput
    uint pixel;
    vec2 uv;           // texture coordinates
    uint material;     // kNone: none, the estimate is an irradiance
    float probability; // of taking the diffuse part here: not divided out of beta
    uint media;        // on this side, see media.h
};
DEVICE_ARRAY(VisiblePoint, VisiblePointArray);

// A camera path's departure by a rough lobe: there lights are sampled.
struct RoughPoint {
    vec3 position;        // on the surface, world [m]
    float error;          // bound on the error of position [m]
    vec3 normal;          // unit, on the side the path came from
    uint depth;           // segments from the camera to here; 0: the path did not leave by a rough lobe
    vec3 geometricNormal; // unit, on the same side
    uint samplerSeed;
    vec3 wo;     // unit, to where the path came from
    uint from;   // see Ray; of a ray that stays on this side
    vec3 beta;   // path throughput, probability of the lobe divided out
    uint result; // index where its light is added: the pixel, or the path if pixels have several
    vec2 uv;     // texture coordinates
    uint material;
    uint isCoat; // 1: it left by the material's coat, 0: by its other lobe
    uint media;  // on the side the path came from, see media.h
    uint beyond; // media on the other side
};
DEVICE_ARRAY(RoughPoint, RoughPointArray);

// A photon path in flight.
struct PhotonPath {
    vec3 power;  // flux [W], light pmf and photon count divided out
    uint photon; // number of the photon in its pass
    uint light;  // the light that emitted it
    uint kind;   // kind of the photon it would store on a diffuse surface: kPhoton…
    uint media;  // around the present ray, see media.h
};
DEVICE_ARRAY(PhotonPath, PhotonPathArray);

// Kinds of photons, by how the light reached the diffuse surface.
SHARED_CONSTANT kPhotonDirect = 0u;   // straight from the light
SHARED_CONSTANT kPhotonIndirect = 1u; // after a diffuse reflection
SHARED_CONSTANT kPhotonCaustic = 2u;  // only by mirrors, metal and glass
SHARED_CONSTANT kPhotonShadow = 3u;   // occluded: the light does not reach this place; no power

// A stored photon; the sorted photons are also read as two texels each.
struct Photon {
    vec3 position;  // world [m]
    uint direction; // unit vector to where the photon came from, octahedral, kDirectionBits a coordinate; above it,
                    // in a kd-tree, the split axis of this photon: 0, 1, 2
    vec3 power;     // flux [W]
    uint surface; // normal of the surface it landed on, octahedral, kNormalBits a coordinate; above it, two bits of its
                  // kind, then eight: direct and shadow photons, the light (255: that one or a later one); others, the
                  // segments of its path. kNone: no photon
};
DEVICE_ARRAY(Photon, PhotonArray);
SHARED_CONSTANT kDirectionBits = 15u;
SHARED_CONSTANT kSplitAxisShift = 30u;
SHARED_CONSTANT kMarkedPhoton = 0x80000000u; // before sorting: irradiance will be precomputed there
SHARED_CONSTANT kMarkEvery = 4u;             // one photon in this many is marked
SHARED_CONSTANT kNormalBits = 11u;
SHARED_CONSTANT kKindShift = 22u;
SHARED_CONSTANT kLengthShift = 24u;
SHARED_CONSTANT kLengthMax = 255u;

// Where the flux of one emitted photon went [W]; the four add up to it.
struct PhotonFate {
    vec3 stored;   // left on diffuse surfaces where a photon was stored
    vec3 absorbed; // by mirrors, glass and absorbing surfaces
    vec3 escaped;  // out of the scene
    vec3 cutOff;   // would have been reflected at the end of the longest path
};
DEVICE_ARRAY(PhotonFate, PhotonFateArray);

DEVICE_ARRAY(uvec2, UintPairArray);
DEVICE_ARRAY(float, FloatArray);
DEVICE_ARRAY(vec3, ColorArray);

SHARED_END
#endif
