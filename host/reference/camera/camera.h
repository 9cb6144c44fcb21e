// The camera: a pinhole, or a thin lens.
#pragma once

#include "reference/shapes/geometry.h"

#include <cstdint>

namespace hyalite::reference {

struct World;

// The direction through image point (x, y) in [-1, 1]^2, y up, and the centre of the lens is forward + x right + y up.
struct CameraFrame {
    glm::dvec3 position; // centre of the lens, world [m]
    glm::dvec3 forward;  // unit
    glm::dvec3 right;    // length tan(horizontal fov / 2)
    glm::dvec3 up;       // length tan(vertical fov / 2)
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    double lensRadius = 0;    // [m]; 0: a pinhole
    double focusDistance = 1; // along forward, from the lens to the plane of focus [m]
};

// Throws Error(BadInput) if position, look_at and up do not span a frame.
[[nodiscard]] CameraFrame makeCameraFrame(const Camera& camera, const std::string& sceneFile);

// The ray through the pixel (y * width + x, row 0 on top) in a pass: one point of the pixel's own sequence. It starts
// at the centre of the lens or, for a lens with a radius, at a point on it.
[[nodiscard]] Ray generateCameraRay(const CameraFrame& camera, const RenderSettings& render, std::uint32_t pixel,
                                    std::uint32_t pass);
[[nodiscard]] Ray generateCameraRay(const World& world, std::uint32_t pixel, std::uint32_t pass);

} // namespace hyalite::reference
