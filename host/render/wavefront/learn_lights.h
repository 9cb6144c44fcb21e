// Learns what the lights do where the camera looks: see geometry/light_use.h.
#pragma once

#include "geometry/light_use.h"
#include "render/upload/device_scene.h"
#include "render/wavefront/device.h"
#include "scene/model/scene.h"

#include <vector>

namespace hyalite::render {

// True if the scene has as many lights as it takes and the integrator picks some of them.
[[nodiscard]] bool learnsLights(const Scene& scene, const DeviceScene& deviceScene);

// What each light does at the places that the paths of a small picture reach. Deterministic. Waits for the device.
[[nodiscard]] std::vector<LightUse> tryLights(Device& device, const Scene& scene, const DeviceScene& deviceScene);

// Sets the probabilities of the scene's lights on the device from that, if it learns lights; once more from the start
// if they were set before.
void learnLights(Device& device, const Scene& scene, DeviceScene& deviceScene);

} // namespace hyalite::render
