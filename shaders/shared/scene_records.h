// The scene as the kernels see it; host/render uploads it once before the first pass.
#ifndef HYALITE_SHARED_SCENE_RECORDS_H
#define HYALITE_SHARED_SCENE_RECORDS_H
#include "language.h"
#include "materials.h"
SHARED_BEGIN

// The ray through image point (x, y) in [-1, 1]^2, y up, and the centre of the lens has direction forward + x right + y
// up; rays through other points of the lens meet it at focusDistance along forward.
struct CameraRecord {
    vec3 position;       // centre of the lens, world [m]
    vec3 forward;        // unit
    vec3 right;          // length tan(horizontal fov / 2)
    vec3 up;             // length tan(vertical fov / 2)
    uint width;          // [pixels]
    uint height;         // [pixels]
    float lensRadius;    // [m]; 0: a pinhole
    float focusDistance; // from the lens to the plane in focus [m]
    uint media;          // around the lens, see media.h
};

// A triangle of an emitting mesh; its area is positive.
struct LightTriangle {
    vec3 corner; // world [m]
    vec3 edge0;  // from there to the second corner, counter-clockwise from the front [m]
    vec3 edge1;  // to the third [m]
    vec3 normal; // unit, of the front
};
DEVICE_ARRAY(LightTriangle, LightTriangleArray);
DEVICE_ARRAY(vec3, RadianceArray); // [W/(m^2 sr)]
DEVICE_ARRAY(float, CdfArray);     // cumulative probabilities up to and including each element; 1 for the last

SHARED_CONSTANT kLightPoint = 0u;
SHARED_CONSTANT kLightQuad = 1u;
SHARED_CONSTANT kLightDisk = 2u;
SHARED_CONSTANT kLightSphere = 3u;
SHARED_CONSTANT kLightMesh = 4u;
SHARED_CONSTANT kLightSpot = 5u;
SHARED_CONSTANT kLightBeam = 6u;        // parallel, from a disc
SHARED_CONSTANT kLightDirectional = 7u; // parallel, from beyond the scene onto all of it
SHARED_CONSTANT kLightEnvironment = 8u; // from beyond the scene in all directions; the first light if the scene has one

// A node of the hierarchy over the lights, see lights/pick_light.glsl.
struct LightNode {
    vec3 center;     // of a sphere around the node's lights, world [m]; beam: of the disc where it starts
    float radius;    // of that sphere or disc [m]; light from beyond the scene: 0
    vec3 axis;       // unit, of the cone in which the lights shine undiminished; beam: its direction
    float cosSpread; // cosine and sine of the cone's half-angle
    float sinSpread;
    float cosFade;   // cosine of the angle outside the cone at which nothing is left
    float intensity; // the lights' largest, summed [W/sr, or W/m^2 of a far light, over a common unit]
    uint parent;     // kNone: the root, or a far light
    uint second;     // second child; the first is the next node; 0: the node is a light
    uint light;      // that light
};
DEVICE_ARRAY(LightNode, LightNodeArray);

struct LightHierarchy {
    LightNodeArray nodes; // the far lights, whose strength does not fall off with distance; then the others' tree,
                          // depth first
    uint lightCount;
    uint farCount; // number of far lights; the root of the tree, unless all are far
};
DEVICE_ARRAY(LightHierarchy, LightHierarchyArray);

struct LightRecord {
    uint type;
    vec3 position;  // point, spot: place; quad: corner; disk, sphere, beam: centre; directional, environment: centre of
                    // the scene [m]
    vec3 edge0;     // quad: edge; disk: axis [m]
    vec3 edge1;     // quad: edge; disk: axis [m]
    vec3 normal;    // unit. quad, disk: the emitting side; spot, beam, directional: the direction of the light
    float radius;   // sphere; beam, directional, environment: of the disc where photons start [m]
    float distance; // directional, environment: from `position` to that disc's centre, against the light [m]
    vec2 cone;      // spot: 1 - cos of the angles from the axis at which the falloff begins and ends
    float error;    // mesh: bound on the error of a point's coordinates, by either way to compute it [m]
    float area;     // of the surface, or of the disc where photons start [m^2]
    vec3 emission;  // point, spot: intensity on the axis [W/sr]; beam, directional: irradiance [W/m^2]; surfaces:
                    // radiance [W/(m^2 sr)]; environment: mean radiance of all directions [W/(m^2 sr)]
    vec3 power;     // flux [W]
    float pmf;      // probability that a photon picks this light; also part of a shadow ray's, see pickLightAt
    float cdf;      // cumulative pmf up to and including this light; 1 for the last
    uint columns;   // mesh: triangles; environment: texels of a row
    uint rows;      // environment
    float rotation; // environment: about +y, counter-clockwise [turns], in [0, 1)
    CdfArray cdfs;  // mesh: triangles by area; environment: the rows, then the texels of each row
    LightTriangleArray triangles;
    RadianceArray texels;          // environment: row by row, the upper one first
    LightHierarchyArray hierarchy; // one, of all lights
    uint node;                     // this light's, in the hierarchy
    uint isFar;                    // 1: a far light (LightHierarchy), else 0
    LightNode extent;              // a copy of that node
    uint media;                    // around it, where its photons start, see media.h
};
DEVICE_ARRAY(LightRecord, LightArray);

// A sphere around something specular: caustic photons are aimed at it.
struct TargetRecord {
    vec3 center;  // world [m]
    float radius; // [m]; 3e38: unbounded
};
DEVICE_ARRAY(TargetRecord, TargetArray);

// An object is eight texels of the object table; the fourth is (type and flags, material, light, root) as bits, and the
// others hold what the shape needs:
//   sphere:      0 (center, radius)  1 (center.center - radius^2, -, -, -)
//   flat shapes: 0 (unit normal n, n.corner)  1 (U, u0)  2 (V, v0): a point p of the plane has the coordinates
//                u = U.p + u0, v = V.p + v0; a quad is [0, 1]^2, a disk the unit circle, a plane is unbounded
//   mesh:        0 1 2 rows of the 3x4 matrix from world to object space; root: node of its hierarchy
//   quadric:     0 1 2 rows (L, c) of the map from world to the space of the form, p -> L (p - c); with the form
//                a x^2 + 2b xy + 2c xz + 2d x + e y^2 + 2f yz + 2g y + h z^2 + 2i z + j and the box lo, hi in that
//                space: 4 (a, e, h, j)  5 (b, c, f, lo.x)  6 (d, g, i, hi.x)  7 (lo.y, hi.y, lo.z, hi.z)
//   torus:       0 1 2 likewise  4 (major, minor, -, -)
//   csg:         0 (first leaf, leaf count as bits, reach, -)  1 (center, radius) of a sphere around it; reach: largest
//                coordinate of its tori and meshes; root: texel of the geometry table that holds its program
// Leaves of CSG are separate objects, after those that rays are traced against.
SHARED_CONSTANT kTexelsPerObject = 8u;
SHARED_CONSTANT kShapeSphere = 0u;
SHARED_CONSTANT kShapeQuad = 1u;
SHARED_CONSTANT kShapeDisk = 2u;
SHARED_CONSTANT kShapePlane = 3u;
SHARED_CONSTANT kShapeQuadric = 4u;
SHARED_CONSTANT kShapeTorus = 5u;
SHARED_CONSTANT kShapeMesh = 6u;
SHARED_CONSTANT kShapeCsg = 7u;
SHARED_CONSTANT kShapeTypeMask = 0xffu;
SHARED_CONSTANT kShapeOpen = 0x100u;      // quadric: its box cuts the surface and does not close it
SHARED_CONSTANT kShapeReversed = 0x200u;  // leaf of CSG: its inside is outside the solid
SHARED_CONSTANT kShapeLeaf = 0x400u;      // leaf of CSG: the header's `light` names the object it is part of
SHARED_CONSTANT kShapeSmooth = 0x800u;    // mesh: it has normals
SHARED_CONSTANT kShapeRequired = 0x1000u; // required leaf of CSG: a point outside it is outside the solid

// Values of Hit.primitive for a quadric: the form's own surface, or 1 + 2 * axis + (1 on the high side) for a face of
// its box.
SHARED_CONSTANT kPartForm = 0u;

// A CSG program is one texel of the geometry table: postfix steps of two bits each, the first in the lowest bits, on a
// stack of truth values. 32 leaves take 63 steps.
SHARED_CONSTANT kCsgLeaf = 0u; // pushes whether the point is inside the next leaf
SHARED_CONSTANT kCsgUnion = 1u;
SHARED_CONSTANT kCsgIntersection = 2u;
SHARED_CONSTANT kCsgDifference = 3u; // the lower of the top two minus the upper

// The geometry table consists of records of three texels, so that a ray loads triangles and nodes alike: first the
// triangles of all meshes, then the nodes of the hierarchies, then the CSG programs.
SHARED_CONSTANT kTexelsPerRecord = 3u;

// The record of a triangle: its corners, object space [m], as bits; w is unused. Smooth normals, if a mesh has them,
// are in an array, three per triangle.
DEVICE_ARRAY(vec3, NormalArray); // zero vector: flat

// The texture coordinates of a triangle's corners are two texels of a separate table, which is empty if the scene has
// no textures: (u0, v0, u1, v1) (u2, v2, -, -).
SHARED_CONSTANT kTexelsPerCoordinates = 2u;

// A texture is three texels at the head of the texture table; after them come the texels of the images, row by row from
// the top:
//   image:   0 (kTextureImage, first texel, width, height) as bits
//   checker: 0 (kTextureChecker… as bits, first colour)  1 (cells per metre or per unit of u and v, second colour)
//            2 in the world: the scene's origin [cells], modulo 2
//   custom:  0 (kTextureCustom, number among the scene's custom textures, -, -) as bits  1 its parameters
//            2 the scene's origin, world [m]
// The scene's origin is what its coordinates on the device are relative to; see host/scene/model/recentre.h.
SHARED_CONSTANT kTexelsPerTexture = 3u;
SHARED_CONSTANT kTextureImage = 0u;
SHARED_CONSTANT kTextureCheckerWorld = 1u;
SHARED_CONSTANT kTextureCheckerUv = 2u;
SHARED_CONSTANT kTextureCustom = 3u; // see textures/custom_texture.glsl

// Data for surface evaluation beyond an object's texels; one per object.
struct InstanceRecord {
    vec4 row0; // rows of the 3x4 matrix from object to world space; the identity for shapes in world space
    vec4 row1;
    vec4 row2;
    UintArray neighbors; // objects that it touches, itself among them, the larger ones first: two words each, the
                         // object and, as bits, the largest coordinate of the smaller of the two [m]
    uint neighborCount;  // 0 unless it or one of them is a dielectric
};
DEVICE_ARRAY(InstanceRecord, InstanceArray);

// The record of a node of the 4-wide BVH:
//   (origin.xyz, exponents x | y << 8 | z << 16 | kind 0 << 24 | kind 1 << 28)
//   (lo.x, lo.y, lo.z, hi.x of the children, 8 bits each)
//   (hi.y, hi.z, first node | kind 2 << 28, first element | kind 3 << 28)
// A child's box is origin + byte * 2^(exponent - 127). Its kind: 0 = none, kInnerChild = a node, else a leaf with that
// many elements. The nodes among the children follow one another from the first node on, the leaves' elements from the
// first element on. An entry of a ray's stack is a word: a node's record, or for a leaf bit 31, its count in
// bits 27..30 and its first element, for meshes the record of a triangle, in 0..26.
SHARED_CONSTANT kInnerChild = 15u;
SHARED_CONSTANT kLeafBit = 0x80000000u;
SHARED_CONSTANT kLeafCountShift = 27u;
SHARED_CONSTANT kLeafCountMax = 14u;
SHARED_CONSTANT kLeafFirstMask = 0x07ffffffu;
SHARED_CONSTANT kChildKindShift = 28u;

// Uniform texel buffers, one descriptor set bound once: the tables that traversal and gathering read most.
#define TABLE_GEOMETRY 0
#define TABLE_OBJECTS 1
#define TABLE_PHOTONS 2
#define TABLE_TEXTURES 3
#define TABLE_TEXTURE_COORDINATES 4
#define TABLE_DEBUG 5 // see lib/debug.glsl
#define TABLE_COUNT 6

SHARED_END
#endif
