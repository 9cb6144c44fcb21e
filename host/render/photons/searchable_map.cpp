#include "render/photons/searchable_map.h"

namespace hyalite::render {

namespace {

std::variant<PhotonTree, PhotonGrid> makeStructure(Device& device, PhotonStructure structure) {
    if (structure == PhotonStructure::Grid) {
        return PhotonGrid(device);
    }
    return PhotonTree(device);
}

} // namespace

SearchableMap::SearchableMap(Device& device, PhotonStructure structure)
    : structure_(makeStructure(device, structure)) {}

void SearchableMap::build(Device& device, const gpu::Array<shared::Photon>& photons, std::uint32_t count,
                          const gpu::Array<shared::Photon>& table, std::uint32_t base, float radius) {
    if (auto* grid = std::get_if<PhotonGrid>(&structure_)) {
        grid->build(device, photons, count, radius, table, base);
    } else {
        std::get<PhotonTree>(structure_).build(device, photons, count, table, base);
    }
}

shared::PhotonMapRecord SearchableMap::record() const {
    if (const auto* grid = std::get_if<PhotonGrid>(&structure_)) {
        return grid->map();
    }
    return std::get<PhotonTree>(structure_).map();
}

} // namespace hyalite::render
