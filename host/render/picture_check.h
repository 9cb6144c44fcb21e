// Looks at a finished picture for what is probably not meant.
#pragma once

#include "image/image.h"
#include "scene/model/scene.h"

#include <optional>
#include <string>

namespace hyalite::render {

// A warning if no channel of any pixel is above 0.
[[nodiscard]] std::optional<Warning> blackPicture(const Image& picture, const std::string& sceneFile);

// The same, unless the scene accepts it.
[[nodiscard]] std::optional<Warning> blackPicture(const Image& picture, const Scene& scene);

} // namespace hyalite::render
