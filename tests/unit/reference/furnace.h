// The walls of a closed furnace: every one of them emits and reflects diffusely.
#pragma once

#include "unit/reference/support.h"

namespace hyalite::reference::test {

// A closed cube of 2 m about the origin whose walls have radiance 1, and the albedo.
inline void addFurnace(Scene& scene, double albedo) {
    const std::size_t wall = addMaterial(scene, Diffuse{dvec3(albedo)});
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 n(0);
        dvec3 a(0);
        dvec3 b(0);
        n[axis] = 1;
        a[(axis + 1) % 3] = 2;
        b[(axis + 2) % 3] = 2;
        addObject(scene, Quad{-n - 0.5 * (a + b), a, b}, wall, dvec3(1)); // a x b = n: inwards
        addObject(scene, Quad{n - 0.5 * (a + b), b, a}, wall, dvec3(1));
    }
}

} // namespace hyalite::reference::test
