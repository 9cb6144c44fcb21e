// See medium.h.
#include "reference/media/medium.h"

#include <algorithm>

namespace hyalite::reference {

void Media::enter(std::uint32_t material) {
    if (size_ == kMost) {
        std::shift_left(materials_.begin(), materials_.end(), 1);
        --size_;
    }
    materials_.at(size_++) = material;
}

void Media::leave(std::uint32_t material) {
    for (std::size_t i = size_; i > 0; --i) {
        if (materials_.at(i - 1) == material) {
            std::copy(materials_.begin() + static_cast<std::ptrdiff_t>(i),
                      materials_.begin() + static_cast<std::ptrdiff_t>(size_),
                      materials_.begin() + static_cast<std::ptrdiff_t>(i - 1));
            --size_;
            return;
        }
    }
}

bool Media::operator==(const Media& other) const {
    return std::ranges::equal(list(), other.list());
}

Medium mediumOf(const std::vector<Material>& materials, const Media& media) {
    // The volume of highest priority fills the place; of equal ones, that of the later material, then the last entered
    const auto list = media.list();
    std::size_t base = list.size();
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::uint32_t priority = materials.at(list[i]).model.priority;
        const auto rank = [&](std::size_t at) { return std::pair(materials.at(list[at]).model.priority, list[at]); };
        if (priority > 0 && (base == list.size() || rank(i) >= rank(base))) {
            base = i;
        }
    }
    Medium medium;
    // Those without priority that were entered after it are nested in it, one in the other
    for (std::size_t i = base == list.size() ? 0 : base; i < list.size(); ++i) {
        const MaterialModel& model = materials.at(list[i]).model;
        if (i == base || model.priority == 0) {
            medium = {.material = &materials.at(list[i]), .index = medium.index * model.ior};
        }
    }
    return medium;
}

glm::dvec3 transmittance(const std::vector<Material>& materials, const Media& media, double distance) {
    const Medium medium = mediumOf(materials, media);
    return medium.material != nullptr ? glm::exp(-medium.material->model.absorption * distance) : glm::dvec3(1);
}

Media behind(const std::vector<Material>& materials, std::size_t material, bool front, const Media& media) {
    Media beyond = media;
    const MaterialModel& model = materials.at(material).model;
    if (model.type == shared::kMaterialDielectric && model.thin == 0) {
        if (front) {
            beyond.enter(static_cast<std::uint32_t>(material));
        } else {
            beyond.leave(static_cast<std::uint32_t>(material));
        }
    }
    return beyond;
}

bool hasPriorities(const std::vector<Material>& materials) {
    return std::ranges::any_of(materials, [](const Material& material) { return material.model.priority > 0; });
}

MaterialModel relativeTo(const std::vector<Material>& materials, bool fromMedia, MaterialModel model,
                         const MediaPair& sides) {
    const double here = mediumOf(materials, sides.before).index;
    if (model.type == shared::kMaterialConductor) {
        model.eta /= here;
        model.k /= here;
    }
    if (model.type == shared::kMaterialDielectric && model.thin == 0 && fromMedia) {
        const double there = mediumOf(materials, sides.beyond).index;
        model.ior = sides.front ? there / here : here / there;
    }
    return model;
}

} // namespace hyalite::reference
