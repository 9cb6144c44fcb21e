// See warning.h.
#include "scene/model/warning.h"

#include "scene/model/scene.h"

#include <utility>

namespace hyalite {

void warn(Scene& scene, Warning warning) {
    const auto isSame = [&](const Warning& last) {
        return last.kind == warning.kind && last.where.file == warning.where.file && last.where.line > 0 &&
               last.where.line == warning.where.line && last.where.column == warning.where.column;
    };
    // Copies of an object share a place and follow each other: one warning for all of them
    const bool isRepeated = !scene.warnings.empty() && isSame(scene.warnings.back());
    if (!isRepeated && !scene.accepted.contains(warning.kind)) {
        scene.warnings.push_back(std::move(warning));
    }
}

} // namespace hyalite
