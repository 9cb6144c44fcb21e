// The push constants of the kernels that sort photons into a kd-tree, in the order of the kernels; see
// kernel_arguments.h.
#ifndef HYALITE_SHARED_TREE_ARGUMENTS_H
#define HYALITE_SHARED_TREE_ARGUMENTS_H
#include "photon_map.h"
SHARED_BEGIN

struct MarkPhotonsArguments {
    PhotonArray photons;
    UintArray marks; // out: 1 if the slot holds a photon, else 0
    uint count;      // photon slots
};

// A photon on one of the three lists from which the kd-tree is built. Stored photons are numbered by slot, skipping
// empty ones.
struct KeyedPhoton {
    uvec3 key; // its coordinates, as integers of the same order
    uint photon;
};
DEVICE_ARRAY(KeyedPhoton, KeyedPhotonArray);

struct KeyPhotonsArguments {
    PhotonArray photons;
    UintArray numbers;     // exclusive sums of the marks
    UintArray slots;       // out: slot of each stored photon
    KeyedPhotonArray keys; // out
    UintPairArray pairs;   // out: (key, photon) of the stored photons, axis by axis
    uint count;            // photon slots
    uint stored;
};

SHARED_CONSTANT kRadix = 256u;      // values of one digit of the radix sort
SHARED_CONSTANT kSortChunk = 1024u; // photons that one thread of the sort counts and moves

struct CountDigitsArguments {
    UintPairArray pairs;
    UintArray counts; // out: by axis, digit and chunk
    uint count;       // three times the chunks of a list
    uint stored;
    uint shift; // of the digit in the key
};

struct SortDigitsArguments {
    UintPairArray pairs;
    UintArray places;       // in and out: exclusive sums of the counts
    UintPairArray sorted;   // out, except in the last round
    KeyedPhotonArray keys;  // for the last round
    KeyedPhotonArray lists; // out, in the last round: the photons along each axis
    uint count;             // three times the chunks of a list
    uint stored;
    uint shift;
    uint last; // 1: the last round
};

SHARED_CONSTANT kSplitChunk = 256u; // photons of a node's list that one thread partitions

struct SplitNodesArguments {
    KeyedPhotonArray lists;
    KeyedPhotonArray splits; // out, by node of the level: the splitting photon
    UintArray nodes;         // out, in heap order: the splitting photon, and the axis above kSplitAxisShift
    uint count;              // nodes of the level
    uint level;
    uint stored;
};

struct CountSidesArguments {
    KeyedPhotonArray lists;
    KeyedPhotonArray splits;
    UintArray nodes;
    UintArray counts; // out, by list, node and chunk: photons for the left child
    uint count;       // threads: lists times nodes times chunks
    uint level;
    uint chunks; // of the largest node's list
    uint stored;
};

struct PartSidesArguments {
    KeyedPhotonArray lists;
    KeyedPhotonArray splits;
    UintArray nodes;
    UintArray sums;          // exclusive sums of the counts
    KeyedPhotonArray parted; // out
    uint count;
    uint level;
    uint chunks;
    uint stored;
};

struct FinishSubtreesArguments {
    KeyedPhotonArray lists;  // in and out
    KeyedPhotonArray others; // scratch space of the same size
    UintArray nodes;         // out, see SplitNodesArguments
    uint count;              // subtrees: nodes of the level
    uint level;
    uint stored;
};

struct PlacePhotonsArguments {
    PhotonArray photons;
    UintArray nodes;
    UintArray slots;
    PhotonArray sorted; // out: the tree
    UintArray order;    // out: slot of each node's photon
    uint count;         // stored photons
};

SHARED_END
#endif
