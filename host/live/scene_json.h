// What the page is told of the scene, and of a picture.
#pragma once

#include "live/channel.h"
#include "live/live_renderer.h"

namespace hyalite::live {

// Camera and settings as they are, and the files that the scene is made of.
[[nodiscard]] Json describe(const Scene& scene, const View& view, const std::filesystem::path& file);

[[nodiscard]] Json describe(const LiveRenderer::Frame& frame);

} // namespace hyalite::live
