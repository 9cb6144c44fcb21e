#include "render/photons/photon_slots.h"

#include <algorithm>

namespace hyalite::render {

void reservePhotonSlots(Device& device, gpu::Array<shared::Photon>& photons, std::uint32_t slots) {
    if (photons.count() >= slots) {
        return;
    }
    const std::size_t count = std::max<std::size_t>(slots, 2 * photons.count());
    gpu::Array<shared::Photon> larger(device.context, count, "photons");
    device.commands.copy(photons.buffer(), larger.buffer());
    device.commands.finish();
    photons = std::move(larger);
}

std::vector<shared::Photon> storedPhotons(const gpu::Array<shared::Photon>& photons, std::uint32_t slots) {
    std::vector<shared::Photon> stored = photons.read(0, slots);
    std::erase_if(stored, [](const shared::Photon& photon) { return photon.surface == shared::kNone; });
    return stored;
}

} // namespace hyalite::render
