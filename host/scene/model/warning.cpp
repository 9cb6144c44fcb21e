// See warning.h.
#include "scene/model/warning.h"

#include "scene/model/scene.h"

#include <utility>

namespace hyalite {

void warn(Scene& scene, Warning warning) {
    if (!scene.accepted.contains(warning.kind)) {
        scene.warnings.push_back(std::move(warning));
    }
}

} // namespace hyalite
