// The camera: a pinhole, or a thin lens.
#pragma once

#include "reference/shapes/geometry.h"

#include <cstdint>

namespace hyalite::reference {

struct World;

// The direction through image point (x, y) in [-1, 1]^2, y up, and the middle of the lens is forward + x right + y up.
struct CameraFrame {
    glm::dvec3 position; // middle of the lens, world [m]
    glm::dvec3 forward;  // unit
    glm::dvec3 right;    // length tan(horizontal fov / 2)
    glm::dvec3 up;       // length tan(vertical fov / 2)
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    double lensRadius = 0;    // [m]; 0: a pinhole
    double focusDistance = 1; // along forward, from the lens to the plane that is sharp [m]
};

// Throws Error(BadInput) where position, look_at and up do not span a frame.
[[nodiscard]] CameraFrame makeCameraFrame(const Camera& camera, const std::string& sceneFile);

// The ray through the pixel (y * width + x, row 0 on top) in a pass: one point of the pixel's own sequence, from
// the middle of the lens or, where it has a radius, from a point of it.
[[nodiscard]] Ray generateCameraRay(const World& world, std::uint32_t pixel, std::uint32_t pass);

} // namespace hyalite::reference
