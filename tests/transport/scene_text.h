// Scene files as text, for tables of scenes.
#pragma once

#include "scene/model/scene.h"

#include <iomanip>
#include <map>
#include <sstream>
#include <string>

namespace hyalite::testing {

// The parts one after another; numbers with all their digits, vectors as YAML lists.
template <class... Parts>
[[nodiscard]] std::string text(const Parts&... parts) {
    std::ostringstream out;
    out << std::setprecision(17);
    const auto add = [&](const auto& part) {
        if constexpr (std::is_same_v<std::decay_t<decltype(part)>, glm::dvec3>) {
            out << '[' << part.x << ", " << part.y << ", " << part.z << ']';
        } else {
            out << part;
        }
    };
    (add(parts), ...);
    return out.str();
}

// A camera of 8 x 8 pixels so narrow that all of them see `target` (to 1e-4 rad).
[[nodiscard]] std::string cameraAt(const glm::dvec3& position, const glm::dvec3& target);

// A camera straight above the middle of a square of `width` that fills the picture: it looks along -normal from
// `distance`, with `up` along the square's edge. The picture's pixels are equal parts of the square.
[[nodiscard]] std::string cameraOver(const glm::dvec3& middle, const glm::dvec3& normal, const glm::dvec3& up,
                                     double width, double distance);

// Reads a scene file of this text, which the line "hyalite: 1" completes, beside files of these names and texts.
// Throws what loadScene throws.
[[nodiscard]] Scene sceneFrom(const std::string& body, const std::map<std::string, std::string>& files = {});

} // namespace hyalite::testing
