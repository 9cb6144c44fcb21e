// Lists of media as the kernels pack them.
#pragma once

#include "reference/media/start_media.h"

#include "shaders/shared/media.h"

namespace hyalite::render {

// The word of a list of media of the scene; see shaders/shared/media.h.
[[nodiscard]] inline std::uint32_t mediaWord(const Scene& scene, const reference::Media& media) {
    const std::uint32_t bits = shared::mediumBits(static_cast<std::uint32_t>(scene.materials.size()));
    std::uint32_t word = shared::kNoMedia;
    for (const std::uint32_t material : media.list()) {
        word = shared::enterMedium(word, material, bits);
    }
    return word;
}

// The list of a word.
[[nodiscard]] inline reference::Media mediaOfWord(const Scene& scene, std::uint32_t word) {
    const std::uint32_t bits = shared::mediumBits(static_cast<std::uint32_t>(scene.materials.size()));
    reference::Media media;
    for (std::uint32_t place = shared::mediaCapacity(bits); place > 0; --place) {
        const std::uint32_t material = shared::mediumAt(word, place - 1, bits);
        if (material < scene.materials.size()) {
            media.enter(material);
        }
    }
    return media;
}

} // namespace hyalite::render
