// Objects that a scene lists twice. Two surfaces in one place have no right picture: light would count twice, glass
// would be entered twice, and rounding would decide which of two materials shows.
#pragma once

#include "scene/model/scene.h"

namespace hyalite {

// Drops objects equal to an earlier one in shape, place, material and emission; warns of these and of objects that
// differ from an earlier one only in material or emission. Places are equal if they differ by roundings of doubles.
// Throws Error(BadInput) where two objects of one shape and place emit different light.
void dropRepeatedObjects(Scene& scene);

} // namespace hyalite
