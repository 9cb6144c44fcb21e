// The push constants of try_lights.
#ifndef HYALITE_SHARED_TRY_LIGHTS_ARGUMENTS_H
#define HYALITE_SHARED_TRY_LIGHTS_ARGUMENTS_H
#include "path_records.h"
#include "scene_records.h"
SHARED_BEGIN

// Thread `light * places + place` tries that light at that place.
struct TryLightsArguments {
    VisiblePointArray visiblePoints; // one per place
    MaterialArray materials;
    LightArray lights;
    FloatArray brought;  // in and out: mean of the channels of the unoccluded contributions [W/(m^2 sr)]
    UintPairArray tries; // in and out: number of contributions, and of unoccluded ones
    uint count;          // places times lights
    uint places;
    uint depth; // places this many segments from the camera are tried, others are left out
    uint pass;
    uint rootNode;
};

SHARED_END
#endif
