// The push constants of every kernel, in the order of the pass. Each names what the kernel reads, then what it
// writes, then its numbers; `count` is the number of threads that have work. Where there is a `live`, the queue's size
// on the device says that number, and `count` is the largest that it may be; with a `live` of none it is `count`.
#ifndef HYALITE_SHARED_KERNEL_ARGUMENTS_H
#define HYALITE_SHARED_KERNEL_ARGUMENTS_H
#include "film.h"
#include "grid.h"
#include "path_records.h"
#include "photon_map.h"
#include "queue.h"
#include "scene_records.h"
#include "tree_arguments.h"
SHARED_BEGIN

struct GenerateCameraRaysArguments {
    RayArray rays;         // out, one per pixel
    CameraPathArray paths; // out, one per pixel
    RenderSeed seed;
    CameraRecord camera;
    uint count; // pixels
    uint pass;
};

struct TraceClosestArguments {
    RayArray rays;
    HitArray hits; // out
    uint count;
    uint rootNode; // of the BVH over objects
    uint width;    // where these are the pixels of a picture, its width [pixels]: see pixelOfThread; else 0
    QueueSizeArray live;
};

struct ShadeSurfaceArguments {
    RayArray rays;
    HitArray hits;
    CameraPathArray paths;
    MaterialArray materials;
    LightArray lights;
    NormalArray normals;
    InstanceArray instances;
    VisiblePointArray visiblePoints; // out, by pixel
    ColorArray emitted;              // out, by pixel: added to what is there, but at the first hit
    RayArray nextRays;               // out, one per path
    CameraPathArray nextPaths;       // out, likewise
    UintArray alive;                 // out, likewise: 1 where a next ray stands, else 0
    uint count;
    uint depth;    // segments from the camera to these hits
    uint maxDepth; // no next ray from here on
    uint pass;
    RoughPointArray roughPoints; // out, one per path; untouched in scenes without rough lobes
    uint width; // where these are the pixels of a picture, its width [pixels]: see pixelOfThread; else 0
    QueueSizeArray live;
};

// Where `result` is named: the pixel of rays that start at the camera, else the ray's own number.
struct TraceWhittedArguments {
    UintArray slots;       // where the rays and their paths stand; none: they start at the camera, one per pixel
    RayArray rays;         // of the level before
    CameraPathArray paths; // likewise
    MaterialArray materials;
    LightArray lights;
    NormalArray normals;
    InstanceArray instances;
    ColorArray light;            // out, at the result: radiance [W/(m^2 sr)] emitted and reflected
    UintArray pixels;            // out, unless the rays start at the camera
    RoughPointArray roughPoints; // out, one per ray; untouched in scenes without rough lobes
    RayArray nextRays;           // out, two slots per ray, the first of which is used first
    CameraPathArray nextPaths;   // out, likewise
    UintArray alive;             // out: how many of the ray's slots are used
    RenderSeed seed;
    CameraRecord camera;
    uint count;
    uint depth;    // segments from the camera to these hits
    uint maxDepth; // no next ray from here on
    uint pass;
    float minWeight; // a next ray whose throughput is below this in every channel is not followed
    uint lightCount;
    uint rootNode;
    RayArray keptRays;               // out: where they came from; none: this and what follows is not written
    CameraPathArray keptPaths;       // out: as they came to their hits
    HitArray hits;                   // out
    ColorArray emitted;              // out: of the light, what is emitted
    VisiblePointArray visiblePoints; // out
    QueueSizeArray live;
    UintArray rayCount; // in and out: shadow rays traced, of 64 bits; see lib/counter.glsl
};

struct SampleRoughLightsArguments {
    RoughPointArray roughPoints;
    MaterialArray materials;
    LightArray lights;
    ColorArray direct; // in and out, at RoughPoint.result: radiance [W/(m^2 sr)] is added
    uint count;
    uint lightCount;
    uint light; // sample this one, or kNone: one picked in proportion to power
    uint pass;
    uint rootNode;
    QueueSizeArray live;
    UintArray rayCount; // in and out: shadow rays traced, of 64 bits; see lib/counter.glsl
};

struct SampleLightsArguments {
    VisiblePointArray visiblePoints;
    MaterialArray materials;
    LightArray lights;
    RayArray shadowRays;      // out; tMax = 0: nothing to trace
    ColorArray contributions; // out: radiance [W/(m^2 sr)] if the light is seen
    uint count;
    uint lightCount;
    uint light; // sample this one, or kNone: one picked by the lights' pmf
    uint pass;
    uint maxDepth;
    uint bounceDepth; // 0: all of them, and nothing else brings their light; else those of this depth alone, from which
                      // paths go on and may meet the light too
    uint width;       // where these are the pixels of a picture, its width [pixels]: see pixelOfThread; else 0
    QueueSizeArray live;
    CameraPathArray paths; // those whose pixels have the visible points; none: one visible point per thread
};

// Sends camera paths on from the diffuse surfaces where they have just ended.
struct BouncePathsArguments {
    CameraPathArray paths;           // as they came to their hits
    VisiblePointArray visiblePoints; // by pixel
    MaterialArray materials;
    RayArray nextRays;         // out, one per path
    CameraPathArray nextPaths; // out
    UintArray alive;           // out: 1 where a ray goes on from a diffuse surface, else as it was
    uint count;
    uint depth; // segments from the camera to the visible points
    uint maxDepth;
    uint pass;
    QueueSizeArray live;
};

struct TraceShadowArguments {
    RayArray shadowRays;
    ColorArray contributions;
    ColorArray direct; // in and out: the contributions of unoccluded rays are added
    uint count;
    uint rootNode;
    uint width; // where these are the pixels of a picture, its width [pixels]: see pixelOfThread; else 0
    QueueSizeArray live;
    UintArray rayCount;    // in and out: shadow rays traced, of 64 bits; see lib/counter.glsl
    CameraPathArray paths; // those that the rays are for, whose pixels get the light; none: one pixel per ray
};

struct EmitPhotonsArguments {
    LightArray lights;
    RayArray rays;         // out
    PhotonPathArray paths; // out
    uint first;            // number of the first of these photons in the pass
    uint count;
    uint ofPass; // photons of the whole pass, which share the lights' flux
    uint lightCount;
    uint sequence; // seed of the photons' samplers, see photonSampler
};

struct EmitCausticPhotonsArguments {
    LightArray lights;
    TargetArray targets;
    RayArray rays;         // out
    PhotonPathArray paths; // out
    uint first;            // as above
    uint count;
    uint ofPass;
    uint lightCount;
    uint targetCount;
    uint sequence; // seed of the photons' samplers, see photonSampler
};

struct ScatterPhotonArguments {
    RayArray rays;
    HitArray hits;
    PhotonPathArray paths;
    MaterialArray materials;
    NormalArray normals;
    InstanceArray instances;
    PhotonArray photons;       // out, at firstPhoton + what live counts before + thread; surface = kNone: none stored
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
    uint room;     // for photons: those beyond are left out
    QueueSizeArray live;
};

// Follows photons straight on, through whatever they meet.
struct CastShadowPhotonsArguments {
    RayArray rays;
    HitArray hits;
    PhotonPathArray paths;
    MaterialArray materials;
    NormalArray normals;
    InstanceArray instances;
    PhotonArray photons;       // out, at firstPhoton + what live counts before + thread; surface = kNone: none stored
    RayArray nextRays;         // out
    PhotonPathArray nextPaths; // out
    UintArray alive;           // out
    uint count;
    uint firstPhoton;
    uint room; // for photons: those beyond are left out
    QueueSizeArray live;
};

// Words of the record that a path of either kind carries, which is moved as it is.
SHARED_CONSTANT kPathWords = 7u;

struct CompactPathsArguments {
    UintArray alive;
    UintArray offsets; // exclusive sums of alive
    RayArray nextRays;
    UintArray nextPaths; // kPathWords each
    RayArray rays;       // out
    UintArray paths;     // out
    uint count;
    QueueSizeArray live;
};

// A prefix sum by one workgroup. Of a queue's flags, or of the sums of their chunks, it also finds out how large the
// queue will be.
struct ScanGroupArguments {
    UintArray values;
    UintArray sums; // out: exclusive sums, count + 1 of them: the last is the total
    uint count;     // values
    QueueSizeArray live;
    QueueSizeArray queue;   // the queue as it is; none: what follows is not written
    QueueSizeArray next;    // out, kQueueLevels: the queue of the total
    UintArray elementCount; // in and out: elements of the queue so far, of 64 bits; none: not counted
};

struct SumChunksArguments {
    UintArray values;
    UintArray sums; // out, one per chunk
    uint count;     // values
    QueueSizeArray live;
};

struct ScanChunksArguments {
    UintArray values;
    UintArray chunkOffsets; // what precedes each chunk
    UintArray sums;         // out: exclusive sums, count + 1 of them: the last is the total
    uint count;             // values
    QueueSizeArray live;
};

struct ListNextRaysArguments {
    UintArray alive;        // by path: how many of its slots hold next rays, from the first on
    UintArray chunkOffsets; // exclusive sums of these over chunks of kScanChunk
    UintArray slots;        // out
    uint count;             // paths
    uint slotsOfPath;
    uint room; // for slots: those beyond are left out
    QueueSizeArray live;
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
    MaterialArray materials;
    UintArray cellStarts;
    ColorArray gathered; // out: radiance [W/(m^2 sr)]
    GridRecord grid;
    float radius; // search radius [m]
    uint count;
    uint maxDepth;
    uint width; // where these are the pixels of a picture, its width [pixels]: see pixelOfThread; else 0
};

// Asks at every visible point; a depth of 0 there is no question.
struct NearestPhotonsArguments {
    VisiblePointArray visiblePoints;
    PhotonMapRecord map;
    UintArray found; // out, `nearest` for each point: slots of the photons, the nearest first; behind them kNone
    float radius;    // [m]; of a grid, at most the radius that it was built for
    uint nearest;    // photons to find, at most kNearestCapacity
    uint kinds;      // bit kPhoton… is set for every kind that counts
    uint count;
    uint maxDepth;
};

// How photons are weighted by their distance from the visible point.
SHARED_CONSTANT kFilterNone = 0u;
SHARED_CONSTANT kFilterCone = 1u;
SHARED_CONSTANT kFilterGaussian = 2u;
SHARED_CONSTANT kFilterCustom = 3u; // see photons/custom_filter.glsl

struct EstimateRadianceArguments {
    VisiblePointArray visiblePoints;
    MaterialArray materials;
    PhotonMapRecord map;
    ColorArray gathered;  // out: radiance [W/(m^2 sr)]
    FloatArray radii;     // out: radius of the disc that it comes from [m]; 0 where no light is gathered
    float radius;         // of the largest disc [m]; of a grid, at most the radius that it was built for
    float filterConstant; // cone: k >= 1, the cone's radius over the disc's
    float
        maxChange; // relative change of the estimate, over discs that grow, at which they stop to; 0: they do not stop
    uint nearest;  // photons to find, 2 … kNearestCapacity
    uint kinds;    // bit kPhoton… is set for every kind that counts
    uint filterKind; // kFilter…
    uint count;
    uint maxDepth;
    uint width; // where these are the pixels of a picture, its width [pixels]: see pixelOfThread; else 0
};

// Starts final gathering: one ray from each visible point into its hemisphere.
struct StartGatherRaysArguments {
    VisiblePointArray visiblePoints;
    MaterialArray materials;
    RayArray rays;         // out
    CameraPathArray paths; // out
    UintArray alive;       // out
    uint count;
    uint pass; // gatherPass
};

// Makes visible points of the photons that are marked, so that their irradiance can be estimated.
struct BeginIrradianceArguments {
    PhotonArray photons;
    VisiblePointArray visiblePoints; // out; depth = 0 where there is none
    uint count;                      // photon slots
};

// Turns the marked photons into records of irradiance.
struct StoreIrradianceArguments {
    PhotonArray photons;
    ColorArray irradiance; // [W/m^2]
    PhotonArray records;   // out; power is the irradiance; surface = kNone where there is none
    uint count;            // photon slots
};

// Adds the radiance that the nearest record of irradiance gives each visible point.
struct LookUpIrradianceArguments {
    VisiblePointArray visiblePoints;
    MaterialArray materials;
    ColorArray gathered; // in and out: radiance [W/(m^2 sr)]
    PhotonMapRecord map; // of the records
    float radius;        // no farther than this [m]
    float scale;         // 1 / gather rays
    uint count;
};

// Decides which lights are seen from visible points, by the direct and shadow photons about them.
struct ClassifyVisibilityArguments {
    VisiblePointArray visiblePoints;
    UintArray lit;       // out: bit i is set where light i is seen
    UintArray shadowed;  // out: bit i is set where it is not
    PhotonMapRecord map; // of direct and shadow photons
    uint lightCount;
    uint nearest;  // photons looked at
    uint agreeing; // photons of a light that have to agree
    float radius;  // none farther than this [m]
    uint count;
};

// Spares the shadow rays to a light whose visibility is known.
struct SkipShadowRaysArguments {
    UintArray lit;
    UintArray shadowed;
    RayArray shadowRays; // in and out; tMax = 0: nothing to trace
    ColorArray contributions;
    ColorArray direct;   // in and out
    UintArray raysSaved; // in and out: of 64 bits, see lib/counter.glsl
    uint light;
    uint count;
};

// Draws photons as points: counts per pixel those that the camera sees.
struct SplatPhotonsArguments {
    PhotonArray photons;
    UintArray counts; // in and out, four per pixel, by kind
    CameraRecord camera;
    uint count;
    uint rootNode;
};

// Adds what several paths of one pixel carry, in their order: the first path of each run of equal pixels adds them all.
struct SumPathsArguments {
    UintArray pixels;    // of each path
    ColorArray light;    // of each path
    ColorArray radiance; // in and out, per pixel
    uint count;
    QueueSizeArray live;
};

// What gathering rays found, added to what their pixels gather.
struct AddGatheredLightArguments {
    ColorArray colors;
    ColorArray gathered; // in and out
    uint count;          // pixels
    float scale;         // of the colours
};

struct AccumulateFilmArguments {
    ColorArray colors;
    FilmArray film;   // in and out: sums over passes
    UintArray faults; // in and out, for each of kFilmFaults kinds: how many values, the lowest pixel among theirs
    uint count;       // pixels
};

// What show_surface draws of the first surface that a ray meets.
SHARED_CONSTANT kShowNormals = 0u; // of shading, each coordinate from [-1, 1] to [0, 1]
SHARED_CONSTANT kShowDepth = 1u;   // distance along the ray [m]

struct ShowSurfaceArguments {
    RayArray rays;
    HitArray hits;
    NormalArray normals;
    InstanceArray instances;
    ColorArray colors; // out, one per ray: black where nothing was hit
    uint count;
    uint shown; // kShow…
};

// A layer's sums over the passes of either camera sequence.
struct ResolveFilmArguments {
    FilmArray first;
    FilmArray second;
    ColorArray image; // out: both times scale
    uint count;
    float scale; // 1 / passes
};

SHARED_CONSTANT kErrorChunk = 64u; // so many pixels' relative squared errors one thread adds up, or one less

// How far the means over the passes of the two camera sequences say that their common mean is from the truth.
struct EstimateErrorArguments {
    FilmArray first; // sums over each sequence's passes, layer after layer
    FilmArray second;
    ColorArray errors; // out: standard error of each pixel [W/(m^2 sr)]
    FloatArray sums;   // out, one per thread: of variance / (mean^2 + 0.01), over pixels and channels
    uint count;        // pixels
    float firstPasses; // >= 1
    float secondPasses;
    uint layers;
    uint light; // bit i is set where layer i is part of the picture
};

SHARED_END
#endif
