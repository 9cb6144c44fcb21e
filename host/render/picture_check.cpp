// See picture_check.h.
#include "render/picture_check.h"

#include <algorithm>

namespace hyalite::render {

std::optional<Warning> blackPicture(const Image& picture, const std::string& sceneFile) {
    const bool isLit = std::ranges::any_of(
        picture.pixels, [](const glm::vec3& pixel) { return pixel.x > 0 || pixel.y > 0 || pixel.z > 0; });
    if (isLit) {
        return std::nullopt;
    }
    return Warning{WarningKind::BlackPicture, SourceLocation{.file = sceneFile},
                   "no light reached any pixel: the picture is black",
                   "is the camera inside a closed solid, or facing away from what it should show?"};
}

std::optional<Warning> blackPicture(const Image& picture, const Scene& scene) {
    return scene.accepted.contains(WarningKind::BlackPicture) ? std::nullopt : blackPicture(picture, scene.file);
}

} // namespace hyalite::render
