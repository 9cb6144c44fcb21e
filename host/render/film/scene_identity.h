// What the passes of a render, and its photons, depend on: found out from the scene as the device sees it.
#pragma once

#include "render/film/render_identity.h"
#include "render/upload/device_scene.h"

#include <span>
#include <string_view>

namespace hyalite::gpu {
class ShaderCompiler;
}

namespace hyalite::render {

// Settings as text, with hashes of the scene (files included) and of the shaders.
[[nodiscard]] RenderIdentity identify(const Scene& scene, const DeviceScene& deviceScene,
                                      const gpu::ShaderCompiler& compiler);

// A number that changes with the scene, the camera left out.
[[nodiscard]] std::uint64_t hashOf(const DeviceScene& deviceScene);

// What the photons of a scene depend on: the scene without the camera, the settings that photons are traced by, and the
// GLSL of the kernels that trace them, the scene's own code included. Throws Error(BadInput) where a kernel is not
// there.
[[nodiscard]] RenderIdentity identifyPhotons(const Scene& scene, const DeviceScene& deviceScene,
                                             const gpu::KernelCompiler& compiler);

// The kernels that trace photons and put the photon paths that go on side by side.
[[nodiscard]] std::span<const std::string_view> kernelsOfPhotons();

} // namespace hyalite::render
