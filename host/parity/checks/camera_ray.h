// The start of a camera path: for generate_camera_rays, and for kernels that include it.
#pragma once

#include "parity/check.h"

#include "shaders/shared/path_records.h"

namespace hyalite::parity {

struct CameraRayFields : FieldSet<7> {
    const Field& pixel = exact("pixel");
    const Field& seed = exact("seed");
    const Field& medium = exact("medium");
    const Field& beta = vector("beta", kSame);
    const Field& pdfW = number("pdfW", kSame);
    const Field& origin = place("origin");
    const Field& direction = angle("direction");
};
inline constexpr CameraRayFields kCameraRay;

// `camera`: the scene's, or that of the small picture in which the lights are tried.
void compareCameraRay(const Stage& stage, const reference::CameraFrame& camera, std::size_t i, std::uint32_t pixel,
                      std::uint32_t pass, const shared::Ray& ray, const shared::CameraPath& path);

} // namespace hyalite::parity
