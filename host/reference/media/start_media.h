// The media that paths start in: those around the camera and around each light, found by a ray out of the scene.
#pragma once

#include "reference/media/medium.h"

#include <vector>

namespace hyalite::reference {

struct World;

// The media around a point, the outermost first: a ray from there leaves them one by one.
[[nodiscard]] Media mediaAt(const World& world, const glm::dvec3& point);

struct StartMedia {
    Media camera;
    std::vector<Media> lights; // in the order of makeLights
};

// `world`: has the dielectrics of the scene, and may lack everything else.
[[nodiscard]] StartMedia startMedia(const Scene& scene, const World& world);

// The same, from as much of the scene as that needs.
[[nodiscard]] StartMedia startMedia(const Scene& scene);

} // namespace hyalite::reference
