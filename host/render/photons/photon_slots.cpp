#include "render/photons/photon_slots.h"

#include <algorithm>
#include <iterator>

namespace hyalite::render {

void reservePhotonSlots(Device& device, gpu::Array<shared::Photon>& photons, std::uint32_t slots) {
    if (photons.count() >= slots) {
        return;
    }
    device.commands.finish();
    gpu::Array<shared::Photon> larger(device.context, std::max<std::size_t>(slots, 2 * photons.count()), "photons");
    std::ranges::copy(photons.host(), larger.host().begin());
    photons = std::move(larger);
}

std::vector<shared::Photon> storedPhotons(const gpu::Array<shared::Photon>& photons, std::uint32_t slots) {
    std::vector<shared::Photon> stored;
    std::ranges::copy_if(photons.host().first(slots), std::back_inserter(stored),
                         [](const shared::Photon& photon) { return photon.surface != shared::kNone; });
    return stored;
}

} // namespace hyalite::render
