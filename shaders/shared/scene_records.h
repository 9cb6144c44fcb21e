// The scene as the kernels see it: what host/render uploads once before the first pass.
#ifndef HYALITE_SHARED_SCENE_RECORDS_H
#define HYALITE_SHARED_SCENE_RECORDS_H
#include "language.h"
SHARED_BEGIN

// Pinhole camera: the ray through image point (x, y) in [-1, 1]^2, y up, has direction forward + x right + y up.
struct CameraRecord {
    vec3 position; // world [m]
    vec3 forward;  // unit
    vec3 right;    // length tan(horizontal fov / 2)
    vec3 up;       // length tan(vertical fov / 2)
    uint width;    // [pixels]
    uint height;   // [pixels]
};

SHARED_CONSTANT kMaterialAbsorber = 0u;   // reflects nothing
SHARED_CONSTANT kMaterialDiffuse = 1u;    // color = albedo
SHARED_CONSTANT kMaterialMirror = 2u;     // color = reflectance
SHARED_CONSTANT kMaterialDielectric = 3u; // ior = inside over outside

struct MaterialRecord {
    uint type;
    vec3 color; // fraction reflected per channel, [0, 1]
    float ior;
};
DEVICE_ARRAY(MaterialRecord, MaterialArray);

SHARED_CONSTANT kLightPoint = 0u;
SHARED_CONSTANT kLightQuad = 1u;

struct LightRecord {
    uint type;
    vec3 position; // point: place; quad: corner [m]
    vec3 edge0;    // quad only [m]
    vec3 edge1;    // quad only [m]
    vec3 normal;   // quad only: unit, the emitting side
    float area;    // quad only [m^2]
    vec3 emission; // point: intensity [W/sr]; quad: radiance [W/(m^2 sr)]
    vec3 power;    // flux [W]
    float pmf;     // probability that a photon or a shadow ray picks this light
    float cdf;     // sum of the pmf up to and including this light; 1 for the last
};
DEVICE_ARRAY(LightRecord, LightArray);

// An object is four texels of the object table. The fourth is (type, material, light, mesh root node) as bits.
//   sphere: (center, radius)
//   quad:   (unit normal n, n.corner) (U, u0) (V, v0): a point p of the plane has coordinates u = U.p + u0, v = V.p +
//   v0 mesh:   rows of the 3x4 matrix from world to object space
SHARED_CONSTANT kTexelsPerObject = 4u;
SHARED_CONSTANT kShapeSphere = 0u;
SHARED_CONSTANT kShapeQuad = 1u;
SHARED_CONSTANT kShapeMesh = 2u;

// A triangle is three texels of the triangle table: its corners, object space [m]; w of the first is unused,
// and smooth normals, where a mesh has them, stand in the array below, three per triangle.
SHARED_CONSTANT kTexelsPerTriangle = 3u;
DEVICE_ARRAY(vec3, NormalArray); // zero vector: flat

// What surface evaluation needs of an object beyond its texels; one per object.
struct InstanceRecord {
    vec4 row0; // rows of the 3x4 matrix from object to world space; the identity for shapes kept in world space
    vec4 row1;
    vec4 row2;
};
DEVICE_ARRAY(InstanceRecord, InstanceArray);

// A node of the 4-wide BVH is four texels of the node table:
//   (origin.xyz, exponents x | y << 8 | z << 16) (four child words) (lo.x, lo.y, lo.z, hi.x of the children, 8 bits
//   each) (hi.y, hi.z, -, -)
// A child's box is origin + byte * 2^(exponent - 127). Child word: inner = node index; leaf = bit 31, count in bits
// 27..30, first element in 0..26; kNone = no child.
SHARED_CONSTANT kTexelsPerNode = 4u;
SHARED_CONSTANT kLeafBit = 0x80000000u;
SHARED_CONSTANT kLeafCountShift = 27u;
SHARED_CONSTANT kLeafCountMax = 15u;
SHARED_CONSTANT kLeafFirstMask = 0x07ffffffu;

// Uniform texel buffers, one descriptor set bound once: the tables that traversal and gathering read most.
#define TABLE_NODES 0
#define TABLE_OBJECTS 1
#define TABLE_TRIANGLES 2
#define TABLE_PHOTONS 3
#define TABLE_COUNT 4

SHARED_END
#endif
