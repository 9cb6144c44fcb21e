// The rays that are measured: those that rendering the scene traces, made by the kernels that make them there.
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
    bool shadow = false; // any hit ends it
    std::vector<shared::Ray> rays;
};

// camera: one a pixel, row by row. bounce: those that go on from where these hit, by the cosine from diffuse surfaces,
// in the same order. shuffled: the same in random order. shadow: from the diffuse hits to points on the lights.
// Sets without a ray are left out.
[[nodiscard]] std::vector<RaySet> makeRaySets(render::Device& device, const Scene& scene,
                                              const render::DeviceScene& deviceScene);

} // namespace hyalite::bench
