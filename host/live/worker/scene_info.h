// What the server is told of a scene and of a picture.
#pragma once

#include "live/messages/messages.h"
#include "live/worker/live_renderer.h"

namespace hyalite::live {

// The camera and settings in effect, and the GLSL files of the scene.
[[nodiscard]] SceneInfo sceneInfoOf(const Scene& scene, const View& view);

// Everything but the revision and the names of the layers.
[[nodiscard]] PictureInfo pictureInfoOf(const LiveRenderer::Frame& frame);

} // namespace hyalite::live
