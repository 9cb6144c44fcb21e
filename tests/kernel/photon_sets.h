// Sets of photons that are hard to search, and their twins in the reference.
#pragma once

#include "kernel/kernel_support.h"
#include "reference/photons/photons.h"

#include <string>

namespace hyalite::testing {

// An upward surface's photon, arriving from above, after two segments. Octahedral (0, 0, 1): both coordinates at the
// middle, to one step in 2047 and 32767.
inline shared::Photon upwardPhoton(const vec3& position, float power) {
    constexpr std::uint32_t up11 = 0x3ffU | 0x3ffU << 11U;
    constexpr std::uint32_t up15 = 0x3fffU | 0x3fffU << 15U;
    constexpr std::uint32_t kind = shared::kPhotonIndirect << shared::kKindShift | 2U << shared::kLengthShift;
    return {position, up15, vec3(power), up11 | kind};
}

struct PhotonSet {
    std::string name;
    std::vector<vec3> positions;
};

// `count` photons in each of the large sets.
inline std::vector<PhotonSet> hardPhotonSets(std::uint32_t count) {
    reference::test::Random random;
    std::vector<PhotonSet> sets{{"none", {}},    {"one", {vec3(0.1F)}}, {"two", {vec3(0.1F), vec3(0.1F, 0.1F, -0.2F)}},
                                {"planar", {}},  {"volume", {}},        {"clustered", {}},
                                {"lattice", {}}, {"coincident", {}}};
    for (std::uint32_t i = 0; i < count; ++i) {
        const dvec3 p = random.inCube(1);
        sets[3].positions.emplace_back(p.x, p.y, 0);
        sets[4].positions.emplace_back(p);
        sets[5].positions.emplace_back(0.3 + 0.01 * p.x * p.x * p.x, 0.01 * p.y, 0.001 * p.z);
        sets[6].positions.push_back(vec3(glm::round(8.0 * p)) / 8.0F); // many places, each many times
    }
    sets[7].positions.assign(count / 4, vec3(-0.5, 0.25, 0));
    return sets;
}

// In slots of which every fourth is empty.
inline std::vector<shared::Photon> slotsOf(const PhotonSet& set) {
    std::vector<shared::Photon> photons;
    for (std::size_t i = 0; i < set.positions.size(); ++i) {
        photons.push_back(upwardPhoton(set.positions[i], 1 + static_cast<float>(i % 7)));
        if (i % 3 == 0) {
            photons.push_back(photons.back());
            photons.back().surface = shared::kNone;
        }
    }
    return photons;
}

} // namespace hyalite::testing
