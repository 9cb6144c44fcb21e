// Everything that the passes of a render, and its photons, depend on: determined from the scene as the device sees it.
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

// A hash of the scene without the camera.
[[nodiscard]] std::uint64_t hashOf(const DeviceScene& deviceScene);

// Everything that the photons of a scene depend on: the scene without the camera, the settings that affect photon
// tracing, and the GLSL of the kernels that trace them, including the scene's own code. Throws Error(BadInput) if a
// kernel is missing.
[[nodiscard]] RenderIdentity identifyPhotons(const Scene& scene, const DeviceScene& deviceScene,
                                             const gpu::KernelCompiler& compiler);

// The kernels that trace photons and compact the surviving photon paths.
[[nodiscard]] std::span<const std::string_view> kernelsOfPhotons();

} // namespace hyalite::render
