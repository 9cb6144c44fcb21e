// A photon map as the kernels that search it see it: the place and order of its photons in the photon table.
#ifndef HYALITE_SHARED_PHOTON_MAP_H
#define HYALITE_SHARED_PHOTON_MAP_H
#include "grid.h"
#include "path_records.h"
#include "scene_records.h"
SHARED_BEGIN

// The search structure; a specialization constant of the kernels that search.
SHARED_CONSTANT kPhotonGrid = 0u;
SHARED_CONSTANT kPhotonTree = 1u;

struct PhotonMapRecord {
    UintArray order;      // slot that each photon of the map came from
    UintArray cellStarts; // grid only: first photon of each bucket, then the end of the last
    GridRecord grid;      // grid only
    uint base;            // of the map's first photon in the photon table
    uint count;           // photons
};

SHARED_END
#endif
