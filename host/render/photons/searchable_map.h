// A photon map that kernels can search, in the structure that the settings choose.
#pragma once

#include "render/photons/photon_grid.h"
#include "render/photons/photon_tree.h"
#include "scene/model/scene.h"

#include <variant>

namespace hyalite::render {

class SearchableMap {
public:
    SearchableMap(Device& device, PhotonStructure structure);

    // Sorts the photons into `table`, from `base` on, for searches up to `radius` [m].
    void build(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t count,
               const gpu::Array<shared::Photon>& table, std::uint32_t base, float radius);

    [[nodiscard]] shared::PhotonMapRecord record() const;

private:
    std::variant<PhotonTree, PhotonGrid> structure_;
};

} // namespace hyalite::render
