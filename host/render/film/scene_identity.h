// What the passes of a render, and its photons, depend on: found out from the scene as the device sees it.
#pragma once

#include "render/film/render_identity.h"
#include "render/upload/device_scene.h"

namespace hyalite::gpu {
class ShaderCompiler;
}

namespace hyalite::render {

// Settings as text, with hashes of the scene (files included) and of the shaders.
[[nodiscard]] RenderIdentity identify(const Scene& scene, const DeviceScene& deviceScene,
                                      const gpu::ShaderCompiler& compiler);

// A number that changes with the scene, the camera left out.
[[nodiscard]] std::uint64_t hashOf(const DeviceScene& deviceScene);

// A number that changes with everything the photons depend on: the scene without the camera, and the settings that
// photons are traced by.
[[nodiscard]] std::uint64_t photonFingerprint(const Scene& scene, const DeviceScene& deviceScene);

} // namespace hyalite::render
