// The push constants of every kernel, in the order of the pass. Each names what the kernel reads, then what it
// writes, then its numbers; `count` is the number of threads that have work.
#ifndef HYALITE_SHARED_KERNEL_ARGUMENTS_H
#define HYALITE_SHARED_KERNEL_ARGUMENTS_H
#include "grid.h"
#include "path_records.h"
#include "scene_records.h"
SHARED_BEGIN

struct GenerateCameraRaysArguments {
    RayArray rays;         // out, one per pixel
    CameraPathArray paths; // out, one per pixel
    CameraRecord camera;
    uint count; // pixels
    uint seed;
    uint pass;
};

struct TraceClosestArguments {
    RayArray rays;
    HitArray hits; // out
    uint count;
    uint rootNode; // of the BVH over objects
};

// Follows one of reflection and refraction (split = 0) or both (split = 1); see the kernel for what stands where.
struct ShadeSurfaceArguments {
    RayArray rays;
    HitArray hits;
    CameraPathArray paths;
    MaterialArray materials;
    LightArray lights;
    NormalArray normals;
    InstanceArray instances;
    VisiblePointArray visiblePoints; // out
    ColorArray emitted;              // out
    RayArray nextRays;               // out, 1 + split slots per path
    CameraPathArray nextPaths;       // out, likewise
    UintArray alive;                 // out, likewise: 1 where a next ray stands, else 0
    uint count;
    uint depth;    // segments from the camera to these hits
    uint maxDepth; // no next ray from here on
    uint pass;
    uint split;
    float minWeight;             // a next ray whose throughput is below this in every channel is not followed
    RoughPointArray roughPoints; // out, one per path; untouched in scenes without rough lobes
};

struct SampleRoughLightsArguments {
    RoughPointArray roughPoints;
    LightArray lights;
    ColorArray direct; // in and out, at RoughPoint.result: radiance [W/(m^2 sr)] is added
    uint count;
    uint lightCount;
    uint light; // sample this one, or kNone: one picked in proportion to power
    uint pass;
    uint rootNode;
};

struct SampleLightsArguments {
    VisiblePointArray visiblePoints;
    LightArray lights;
    RayArray shadowRays;      // out; tMax = 0: nothing to trace
    ColorArray contributions; // out: radiance [W/(m^2 sr)] if the light is seen
    uint count;
    uint lightCount;
    uint light; // sample this one, or kNone: one picked in proportion to power
    uint pass;
    uint maxDepth;
};

struct TraceShadowArguments {
    RayArray shadowRays;
    ColorArray contributions;
    ColorArray direct; // in and out: the contributions of unoccluded rays are added
    uint count;
    uint rootNode;
};

struct EmitPhotonsArguments {
    LightArray lights;
    RayArray rays;         // out
    PhotonPathArray paths; // out
    uint count;            // photons emitted in this pass
    uint lightCount;
    uint sequence; // seed of the photons' samplers, see photonSampler
};

struct ScatterPhotonArguments {
    RayArray rays;
    HitArray hits;
    PhotonPathArray paths;
    MaterialArray materials;
    NormalArray normals;
    InstanceArray instances;
    PhotonArray photons;       // out, at firstPhoton + thread; surface = kNone where none is stored
    PhotonFateArray fates;     // in and out, by number of the photon; unused without `account`
    RayArray nextRays;         // out
    PhotonPathArray nextPaths; // out
    UintArray alive;           // out
    uint count;
    uint firstPhoton;
    uint depth; // segments from the light to these hits
    uint maxDepth;
    uint sequence; // seed of the photons' samplers, see photonSampler
    uint kinds;    // bit kPhoton… is set for every kind that is to be stored; paths that can store no more end
    uint account;  // 1: keep account of what becomes of the flux
};

struct CompactCameraPathsArguments {
    UintArray alive;
    UintArray offsets; // exclusive sums of alive
    RayArray nextRays;
    CameraPathArray nextPaths;
    RayArray rays;         // out
    CameraPathArray paths; // out
    uint count;
};

struct CompactPhotonPathsArguments {
    UintArray alive;
    UintArray offsets;
    RayArray nextRays;
    PhotonPathArray nextPaths;
    RayArray rays;         // out
    PhotonPathArray paths; // out
    uint count;
};

SHARED_CONSTANT kScanChunk = 128u; // values one thread of the scan adds up

struct SumChunksArguments {
    UintArray values;
    UintArray sums; // out, one per chunk
    uint count;     // values
};

struct ScanChunksArguments {
    UintArray values;
    UintArray chunkOffsets; // what precedes each chunk
    UintArray sums;         // out: exclusive sums, count + 1 of them: the last is the total
    uint count;             // values
};

struct CountCellsArguments {
    PhotonArray photons;
    UintArray cellCounts; // in and out, zero before
    UintArray ranks;      // out: how many photons came to the bucket before this one (any order)
    GridRecord grid;
    uint count; // photon slots
};

struct FillCellsArguments {
    PhotonArray photons;
    UintArray cellStarts; // exclusive sums of the counts
    UintArray ranks;
    UintArray order; // out: photon slots by bucket
    GridRecord grid;
    uint count; // photon slots
};

struct OrderCellsArguments {
    UintArray cellStarts;
    UintArray order; // in and out: each bucket ascending
    uint count;      // buckets
};

struct SortPhotonsArguments {
    PhotonArray photons;
    UintArray order;
    PhotonArray sorted; // out
    uint count;         // stored photons
};

struct GatherRadianceArguments {
    VisiblePointArray visiblePoints;
    UintArray cellStarts;
    ColorArray gathered; // out: radiance [W/(m^2 sr)]
    GridRecord grid;
    float radius; // search radius [m]
    uint count;
    uint maxDepth;
};

// Adds what several paths of one pixel carry, in their order: the first path of each run of equal pixels adds them all.
struct SumPathsArguments {
    CameraPathArray paths;
    ColorArray emitted;
    ColorArray direct;
    ColorArray radiance; // in and out, per pixel
    uint count;
};

struct AccumulateFilmArguments {
    ColorArray colors;
    ColorArray film; // in and out: sums over passes
    uint count;      // pixels
};

struct ResolveFilmArguments {
    ColorArray film;
    ColorArray image; // out: film times scale
    uint count;
    float scale; // 1 / passes
};

SHARED_END
#endif
