// What travels from kernel to kernel along paths, and what the photon pass leaves behind.
#ifndef HYALITE_SHARED_PATH_RECORDS_H
#define HYALITE_SHARED_PATH_RECORDS_H
#include "language.h"
SHARED_BEGIN

struct Ray {
    vec3 origin;    // world [m], already moved off the surface it leaves
    float tMax;     // the ray ends here; in units of |direction|
    vec3 direction; // unit
    uint from;      // 0: it leaves no object; else 1 + the object it leaves, and kRayInside where it runs inside that
};
DEVICE_ARRAY(Ray, RayArray);

// What a ray knows of the object it leaves decides where rounding cannot: at an edge, a point moved off one surface by
// its error may still be on the wrong side of the other.
SHARED_CONSTANT kRayInside = 0x80000000u;

struct Hit {
    float t;        // distance along the ray [m]
    uint object;    // kNone: nothing was hit; of a CSG object, the leaf whose surface it is
    uint primitive; // mesh: triangle of the triangle table; quadric: part, see kPartForm; 0 for other shapes. Of CSG
                    // with kHitEnters where the ray enters the solid
    vec2 uv;        // flat shapes: coordinates in the plane; triangle: barycentric of its second and third corner
};
DEVICE_ARRAY(Hit, HitArray);
SHARED_CONSTANT kHitEnters = 0x80000000u;

// The state of a camera path that has not yet met a diffuse surface.
struct CameraPath {
    vec3 beta;        // throughput: what one unit of radiance along the present ray adds to the pixel
    uint pixel;       // y * width + x, row 0 on top
    uint samplerSeed; // see Sampler; the index is the pass
};
DEVICE_ARRAY(CameraPath, CameraPathArray);

// Where a camera path first meets a diffuse surface: there the photons are gathered and the lights are sampled.
struct VisiblePoint {
    vec3 position; // world [m]
    uint depth;    // segments from the camera to here; 0: the path found no diffuse surface
    vec3 normal;   // unit, on the side the path came from
    uint samplerSeed;
    vec3 f; // path throughput times the BRDF albedo / pi [1/sr]
    uint pixel;
    uint from; // see Ray
};
DEVICE_ARRAY(VisiblePoint, VisiblePointArray);

// Photon path in flight.
struct PhotonPath {
    vec3 power;  // flux [W], light pmf and photon count divided out
    uint photon; // number of the photon in its pass
};
DEVICE_ARRAY(PhotonPath, PhotonPathArray);

// A stored photon; the sorted photons are also read as two texels each.
struct Photon {
    vec3 position;  // world [m]
    uint direction; // unit vector towards where the photon came from, octahedral, 16 bits a coordinate
    vec3 power;     // flux [W]
    uint surface;   // normal of the surface it landed on, octahedral, 12 bits a coordinate; path length above, 8 bits
};
DEVICE_ARRAY(Photon, PhotonArray);

DEVICE_ARRAY(uint, UintArray);
DEVICE_ARRAY(vec3, ColorArray);

SHARED_END
#endif
