#include "transport/scene_text.h"

#include "scene/load/load_scene.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>

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

namespace {

// Removed with everything in it. (The folder of the scene tests reports to Catch2, and audits run without it.)
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "hyalite-transport-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            throw std::runtime_error("cannot create " + name);
        }
        path_ = name;
    }
    ~Folder() {
        std::error_code ignored; // a destructor cannot report it, and the system cleans up the folder
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        const std::filesystem::path file = path_ / name;
        if (!(std::ofstream(file, std::ios::binary) << bytes).flush()) {
            throw std::runtime_error("cannot write " + file.string());
        }
        return file;
    }

private:
    std::filesystem::path path_;
};

} // namespace

Scene sceneFrom(const std::string& body, const std::map<std::string, std::string>& files) {
    const Folder folder;
    for (const auto& [name, bytes] : files) {
        static_cast<void>(folder.write(name, bytes));
    }
    return loadScene(folder.write("scene.yaml", "hyalite: 1\n" + body));
}

} // namespace hyalite::testing
