#include "scene/yaml/find_material.h"

#include <string>
#include <vector>

namespace hyalite {

std::size_t findMaterial(const Value& name, const Scene& scene) {
    const std::string wanted = name.text();
    std::vector<std::string> known;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (scene.materials[i].name == wanted) {
            return i;
        }
        known.push_back(scene.materials[i].name);
    }
    failUnknownWord(name, "material", known);
}

} // namespace hyalite
