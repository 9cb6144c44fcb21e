#include "geometry/media_needs.h"

#include "scene/model/bounds.h"

#include "shaders/shared/limits.h"
#include "shaders/shared/media.h"

#include <algorithm>
#include <cmath>

namespace hyalite {

namespace {

// Calls visit(model) for the material of the object, or of every leaf of a CSG object, until it returns true.
template <class Visit>
bool anyMaterial(const Scene& scene, const Object& object, Visit&& visit) {
    const auto isOne = [&](const Object& part) {
        return part.material && visit(scene.materials.at(*part.material).model);
    };
    const auto* csg = std::get_if<Csg>(&object.shape);
    if (csg == nullptr) {
        return isOne(object);
    }
    const auto leaves = static_cast<std::size_t>(std::ranges::count(csg->program, CsgStep::Leaf));
    return std::any_of(scene.csgLeaves.begin() + static_cast<std::ptrdiff_t>(csg->firstLeaf),
                       scene.csgLeaves.begin() + static_cast<std::ptrdiff_t>(csg->firstLeaf + leaves), isOne);
}

bool meet(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

// True if the box of some metal meets that of a dielectric.
bool hasMetalInGlass(const Scene& scene) {
    const auto isMetal = [](const MaterialModel& model) { return model.type == shared::kMaterialConductor; };
    std::vector<Bounds> glass;
    std::vector<Bounds> metal;
    for (const Object& object : scene.objects) {
        if (isDielectric(scene, object)) {
            glass.push_back(worldBounds(scene, object));
        }
        if (anyMaterial(scene, object, isMetal)) {
            metal.push_back(worldBounds(scene, object));
        }
    }
    return std::ranges::any_of(metal, [&](const Bounds& box) {
        return std::ranges::any_of(glass, [&](const Bounds& other) { return meet(box, other); });
    });
}

} // namespace

bool isDielectric(const Scene& scene, const Object& object) {
    return anyMaterial(scene, object, [](const MaterialModel& model) {
        return model.type == shared::kMaterialDielectric && model.thin == 0;
    });
}

std::size_t mediaCapacity(const Scene& scene) {
    return shared::mediaCapacity(shared::mediumBits(static_cast<std::uint32_t>(scene.materials.size())));
}

std::uint32_t mediaNeeds(const Scene& scene) {
    std::uint32_t needs = hasMetalInGlass(scene) ? shared::kMediaMetals : 0;
    for (const Material& material : scene.materials) {
        const MaterialModel& model = material.model;
        if (model.type != shared::kMaterialDielectric) {
            continue;
        }
        needs |= model.absorption != glm::dvec3(0) ? shared::kMediaAbsorb : 0;
        if (model.thin != 0) {
            needs |= shared::kMediaThin | shared::kMediaShadows;
        } else if (model.priority > 0) {
            needs |= shared::kMediaIndices | shared::kMediaShadows;
        } else if (std::abs(model.ior - 1) < double{shared::kSmoothIndex}) {
            needs |= shared::kMediaShadows;
        }
    }
    return needs;
}

} // namespace hyalite
