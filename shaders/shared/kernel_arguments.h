// The push constants of every kernel, in the order of the pass. Each lists the kernel's inputs, then its outputs, then
// its numbers; `count` is the number of threads with work. If there is a `live`, it is the queue's size on the device
// and gives that number, and `count` is its upper bound; if `live` is null, `count` is the number.
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
    uint width;    // of the picture if the threads are its pixels [pixels], see pixelOfThread; else 0
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
    ColorArray emitted;              // out, by pixel: overwritten at the first hit, added to at later ones
    RayArray nextRays;               // out, one per path
    CameraPathArray nextPaths;       // out, likewise
    UintArray alive;                 // out, likewise: 1 if there is a next ray, else 0
    uint count;
    uint depth;    // segments from the camera to these hits
    uint maxDepth; // no next ray from here on
    uint pass;
    RoughPointArray roughPoints; // out, one per path; untouched in scenes without rough lobes
    uint width;                  // of the picture if the threads are its pixels [pixels], see pixelOfThread; else 0
    QueueSizeArray live;
};

SHARED_CONSTANT kDepthsUnit = 65536u; // two depths in a word

// The `result` of a ray: its pixel if it starts at the camera, else its own number.
struct TraceWhittedArguments {
    UintArray slots;       // slots of the rays and their paths; null: rays start at the camera, one per pixel
    RayArray rays;         // of the previous level
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
    UintArray alive;             // out: number of the ray's slots in use
    RenderSeed seed;
    CameraRecord camera;
    uint count;
    uint depths; // segments from the camera to these hits, plus kDepthsUnit times the depth from which no next ray
                 // starts
    uint pass;
    float minWeight; // a next ray whose throughput is below this in every channel is not followed
    uint lightCount;
    uint rootNode;
    RayArray keptRays;               // out: the level's rays; null: this and the following are not written
    CameraPathArray keptPaths;       // out: their paths on arrival at the hits
    HitArray hits;                   // out
    ColorArray emitted;              // out: the emitted part of the light
    VisiblePointArray visiblePoints; // out
    QueueSizeArray live;
    UintArray rayCount; // in and out: shadow rays traced, 64 bits; see lib/counter.glsl
};

struct SampleRoughLightsArguments {
    RoughPointArray roughPoints;
    MaterialArray materials;
    LightArray lights;
    ColorArray direct; // in and out, at RoughPoint.result: radiance [W/(m^2 sr)] is added
    uint count;
    uint light; // the light to sample; kNone: one picked for each point, see lights/pick_light.glsl
    uint pass;
    uint rootNode;
    QueueSizeArray live;
    UintArray rayCount;  // in and out: shadow rays traced, 64 bits; see lib/counter.glsl
    UintArray sought;    // in and out, at RoughPoint.result: 1 where light was sought; null: not noted
    NormalArray normals; // read in scenes where shadow rays may pass
    InstanceArray instances;
};

struct SampleLightsArguments {
    VisiblePointArray visiblePoints;
    MaterialArray materials;
    LightArray lights;
    RayArray shadowRays;      // out; tMax = 0: nothing to trace
    ColorArray contributions; // out: radiance [W/(m^2 sr)] if the light is unoccluded
    uint count;
    uint light; // the light to sample; kNone: one picked for each point, see lights/pick_light.glsl
    uint pass;
    uint maxDepth;
    uint bounceDepth; // 0: all of them, and nothing else brings their light; else those of this depth alone, from which
                      // paths go on and may meet the light too
    uint width;       // of the picture if the threads are its pixels [pixels], see pixelOfThread; else 0
    QueueSizeArray live;
    CameraPathArray paths; // paths whose pixels have the visible points; null: one visible point per thread
    UintArray sought;      // in and out, by pixel: 1 where light was sought; null: not noted
};

// Continues camera paths from the diffuse surfaces that they have just reached.
struct BouncePathsArguments {
    CameraPathArray paths;           // on arrival at their hits
    VisiblePointArray visiblePoints; // by pixel
    MaterialArray materials;
    RayArray nextRays;         // out, one per path
    CameraPathArray nextPaths; // out
    UintArray alive;           // out: 1 if a ray continues from a diffuse surface, else unchanged
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
    uint width; // of the picture if the threads are its pixels [pixels], see pixelOfThread; else 0
    QueueSizeArray live;
    UintArray rayCount;              // in and out: shadow rays traced, 64 bits; see lib/counter.glsl
    CameraPathArray paths;           // paths of the shadow rays, whose pixels get the light; null: one pixel per ray
    VisiblePointArray visiblePoints; // by pixel: where the shadow rays start; read in scenes where some may pass
    MaterialArray materials;
    NormalArray normals;
    InstanceArray instances;
};

struct EmitPhotonsArguments {
    LightArray lights;
    RayArray rays;         // out
    PhotonPathArray paths; // out
    uint first;            // number of the first of these photons in the pass
    uint count;
    uint ofPass; // number of photons of the whole pass, which share the lights' flux
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
    PhotonArray photons;       // out, at firstPhoton + live.before + thread; surface = kNone: none stored
    PhotonFateArray fates;     // in and out, by number of the photon; unused without `account`
    RayArray nextRays;         // out
    PhotonPathArray nextPaths; // out
    UintArray alive;           // out
    uint count;
    uint firstPhoton;
    uint depth; // segments from the light to these hits
    uint maxDepth;
    uint sequence; // seed of the photons' samplers, see photonSampler
    uint kinds;    // bit kPhoton… is set for every kind to store; paths that cannot store any more end
    uint account;  // 1: account for where the flux goes
    uint room;     // capacity in photons: photons beyond it are dropped
    QueueSizeArray live;
};

// Follows photons straight through every surface.
struct CastShadowPhotonsArguments {
    RayArray rays;
    HitArray hits;
    PhotonPathArray paths;
    MaterialArray materials;
    NormalArray normals;
    InstanceArray instances;
    PhotonArray photons;       // out, at firstPhoton + live.before + thread; surface = kNone: none stored
    RayArray nextRays;         // out
    PhotonPathArray nextPaths; // out
    UintArray alive;           // out
    uint count;
    uint firstPhoton;
    uint room; // capacity in photons: photons beyond it are dropped
    QueueSizeArray live;
};

// Words of a camera or photon path record, which is moved as is.
SHARED_CONSTANT kPathWords = 7u;

struct CompactPathsArguments {
    UintArray alive;
    UintArray offsets; // exclusive prefix sums of alive
    RayArray nextRays;
    UintArray nextPaths; // kPathWords each
    RayArray rays;       // out
    UintArray paths;     // out
    uint count;
    QueueSizeArray live;
};

// A prefix sum by one workgroup. For a queue's flags, or the sums of their chunks, it also computes the queue's next
// size.
struct ScanGroupArguments {
    UintArray values;
    UintArray sums; // out: exclusive sums, count + 1 values: the last is the total
    uint count;     // values
    QueueSizeArray live;
    QueueSizeArray queue;   // the queue's present size; null: the following are not written
    QueueSizeArray next;    // out, kQueueLevels: the queue's size from the total
    UintArray elementCount; // in and out: elements of the queue so far, 64 bits; null: not counted
};

struct SumChunksArguments {
    UintArray values;
    UintArray sums; // out, one per chunk
    uint count;     // values
    QueueSizeArray live;
};

struct ScanChunksArguments {
    UintArray values;
    UintArray chunkOffsets; // sum of the values before each chunk
    UintArray sums;         // out: exclusive sums, count + 1 values: the last is the total
    uint count;             // values
    QueueSizeArray live;
};

struct ListNextRaysArguments {
    UintArray alive;        // by path: number of its slots that hold next rays, from the first on
    UintArray chunkOffsets; // exclusive sums of alive over chunks of kScanChunk
    UintArray slots;        // out
    uint count;             // paths
    uint slotsOfPath;
    uint room; // capacity in slots: slots beyond it are dropped
    QueueSizeArray live;
};

struct CountCellsArguments {
    PhotonArray photons;
    UintArray cellCounts; // in and out, zero at first
    UintArray ranks;      // out: number of photons that entered the bucket before this one (in any order)
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
    uint width;         // of the picture if the threads are its pixels [pixels], see pixelOfThread; else 0
    float surfaceError; // of positions on surfaces, see errorAround [m]
};

// Searches at every visible point; points of depth 0 are skipped.
struct NearestPhotonsArguments {
    VisiblePointArray visiblePoints;
    PhotonMapRecord map;
    UintArray found; // out, `nearest` for each point: slots of the photons, the nearest first, then kNone
    float radius;    // [m]; of a grid, at most the radius that it was built for
    uint nearest;    // photons to find, at most kNearestCapacity
    uint kinds;      // bit kPhoton… is set for every kind that counts
    uint count;
    uint maxDepth;
    float surfaceError; // of positions on surfaces, see errorAround [m]
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
    FloatArray radii;     // out: radius of the estimate's disc [m]; 0 if no light is gathered
    float radius;         // of the largest disc [m]; of a grid, at most the radius that it was built for
    float filterConstant; // cone: k >= 1, the cone's radius over the disc's
    float maxChange;      // relative change of the estimate at which a growing disc stops; 0: it does not stop
    uint nearest;         // photons to find, 2 … kNearestCapacity
    uint kinds;           // bit kPhoton… is set for every kind that counts
    uint filterKind;      // kFilter…
    uint count;
    uint maxDepth;
    uint width;         // of the picture if the threads are its pixels [pixels], see pixelOfThread; else 0
    float surfaceError; // of positions on surfaces, see errorAround [m]
    vec3 eye;           // centre of the lens, world [m]
    float footprint;    // width of a pixel over the distance from the eye: the least radius of a disc
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

// Turns the marked photons into visible points, so that their irradiance can be estimated.
struct BeginIrradianceArguments {
    PhotonArray photons;
    VisiblePointArray visiblePoints; // out; depth = 0: none
    uint count;                      // photon slots
};

// Turns the marked photons into irradiance records.
struct StoreIrradianceArguments {
    PhotonArray photons;
    ColorArray irradiance; // [W/m^2]
    FloatArray radii;      // of the discs in which it was found [m]
    PhotonArray records;   // out; power is the irradiance, direction the radius; surface = kNone: no record
    uint count;            // photon slots
};

// Adds the radiance at each visible point from the nearest irradiance record.
struct LookUpIrradianceArguments {
    VisiblePointArray visiblePoints; // in and out: depth = 0 where a record was found
    MaterialArray materials;
    ColorArray gathered; // in and out: radiance [W/(m^2 sr)]
    PhotonMapRecord map; // of the records
    float radius;        // no farther than this [m]
    float scale;         // 1 / gather rays
    uint count;
    float surfaceError; // of positions on surfaces, see errorAround [m]
};

// Decides which lights are visible from visible points, from the direct and shadow photons around them.
struct ClassifyVisibilityArguments {
    VisiblePointArray visiblePoints;
    UintArray lit;       // out: bit i is set if light i is visible
    UintArray shadowed;  // out: bit i is set if light i is occluded
    PhotonMapRecord map; // of direct and shadow photons
    uint lightCount;
    uint nearest;  // number of photons to search
    uint agreeing; // number of photons of a light that must agree
    float radius;  // search radius [m]
    uint count;
    float surfaceError; // of positions on surfaces, see errorAround [m]
};

// Skips the shadow rays to a light whose visibility is known.
struct SkipShadowRaysArguments {
    UintArray lit;
    UintArray shadowed;
    RayArray shadowRays; // in and out; tMax = 0: nothing to trace
    ColorArray contributions;
    ColorArray direct;   // in and out
    UintArray raysSaved; // in and out: 64 bits, see lib/counter.glsl
    uint light;
    uint count;
};

// Draws photons as points: counts those visible to the camera, per pixel.
struct SplatPhotonsArguments {
    PhotonArray photons;
    UintArray counts; // in and out, four per pixel, by kind
    CameraRecord camera;
    uint count;
    uint rootNode;
};

// Sums the light of the paths of each pixel, in order: the first path of each run of equal pixels adds the whole run.
struct SumPathsArguments {
    UintArray pixels;    // of each path
    ColorArray light;    // of each path
    ColorArray radiance; // in and out, per pixel
    uint count;
    QueueSizeArray live;
};

// Adds the light found by gathering rays to the gathered light of their pixels.
struct AddGatheredLightArguments {
    ColorArray colors;
    ColorArray gathered; // in and out
    uint count;          // pixels
    float scale;         // of the colours
};

struct AccumulateFilmArguments {
    ColorArray colors;
    FilmArray film;   // in and out: sums over passes
    UintArray faults; // in and out, for each of kFilmFaults kinds: number of values and their lowest pixel
    uint count;       // pixels
};

// What show_surface draws of the first surface that a ray hits.
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

// The means over the passes of both camera sequences.
struct ResolveFilmArguments {
    FilmArray first;
    FilmArray second;
    ColorArray image; // out: the sum of both, times scale
    uint count;
    float scale; // 1 / passes
};

SHARED_CONSTANT kErrorChunk = 64u; // pixels whose relative squared errors one thread sums, at most

// Estimates the error of the mean over all passes from the means of the two camera sequences.
struct EstimateErrorArguments {
    FilmArray first; // sums over each sequence's passes, layer after layer
    FilmArray second;
    UintArray sought;   // by pixel: 1 where light was sought, see SampleLightsArguments
    ColorArray errors;  // out: standard error of each pixel [W/(m^2 sr)]
    FloatArray sums;    // out, one per thread: of variance / (mean^2 + 0.01), over pixels and channels
    UintPairArray dark; // out, one per thread: pixels where no light was found, and those of them where it was sought
    uint count;         // pixels
    float firstPasses;  // >= 1
    float secondPasses;
    uint layers;
    uint light; // bit i is set where layer i is part of the picture
};

SHARED_END
#endif
