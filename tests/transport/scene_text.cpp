#include "transport/scene_text.h"

#include "scene/load/load_scene.h"
#include "unit/scene/scene_test_support.h"

#include <numbers>

namespace hyalite::testing {

using glm::dvec3;

std::string cameraAt(const dvec3& position, const dvec3& target) {
    const bool steep = std::abs(glm::normalize(target - position).y) > 0.9;
    return text("camera: {position: ", position, ", look_at: ", target, ", up: ", steep ? "[0, 0, 1]" : "[0, 1, 0]",
                ", fov: 0.01, resolution: [8, 8]}\n");
}

std::string cameraOver(const dvec3& middle, const dvec3& normal, const dvec3& up, double width, double distance) {
    const double fov = 2 * std::atan(width / 2 / distance) * 180 / std::numbers::pi;
    return text("camera: {position: ", middle + distance * normal, ", look_at: ", middle, ", up: ", up, ", fov: ", fov,
                ", resolution: [8, 8]}\n");
}

Scene sceneFrom(const std::string& body, const std::map<std::string, std::string>& files) {
    test::TemporaryFolder folder;
    for (const auto& [name, bytes] : files) {
        folder.write(name, bytes);
    }
    return loadScene(folder.write("scene.yaml", "hyalite: 1\n" + body));
}

} // namespace hyalite::testing
