// The measured rays: rays that a render of the scene traces, made by the render's own kernels.
#pragma once

#include "render/upload/device_scene.h"
#include "render/wavefront/device.h"
#include "scene/model/scene.h"

#include "shaders/shared/path_records.h"

#include <string>
#include <vector>

namespace hyalite::bench {

struct RaySet {
    std::string name;
    bool shadow = false; // any-hit rays
    std::vector<shared::Ray> rays;
};

// camera: one ray per pixel, row by row. bounce: rays that continue from the camera rays' hits, cosine-distributed at
// diffuse surfaces, in the same order. shuffled: the bounce rays in random order. shadow: from the diffuse hits to
// points on the lights. Empty sets are left out.
[[nodiscard]] std::vector<RaySet> makeRaySets(render::Device& device, const Scene& scene,
                                              const render::DeviceScene& deviceScene);

} // namespace hyalite::bench
