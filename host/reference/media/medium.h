// The media around a path and the absorption in them: overlapping dielectrics with priorities [SchmidtBudge02], or, for
// dielectrics without, nested in the order in which a path entered them.
#pragma once

#include "scene/model/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hyalite::reference {

// The dielectrics that a path is inside, as indices of materials, in the order in which it entered them.
class Media {
public:
    Media() = default;

    void enter(std::uint32_t material);
    // Removes the last one entered of this material; without any, nothing happens.
    void leave(std::uint32_t material);

    // The outermost first.
    [[nodiscard]] std::span<const std::uint32_t> list() const { return std::span(materials_).first(size_); }
    [[nodiscard]] bool operator==(const Media& other) const;

private:
    static constexpr std::size_t kMost = 32; // a longer list forgets the outermost

    std::array<std::uint32_t, kMost> materials_{};
    std::size_t size_ = 0;
};

// The medium that fills a place inside all the media of a list.
struct Medium {
    const Material* material = nullptr; // nullptr: none of them
    double index = 1;                   // over that of vacuum
};
[[nodiscard]] Medium mediumOf(const std::vector<Material>& materials, const Media& media);

// Fraction of the light that is left after a distance [m] there.
[[nodiscard]] glm::dvec3 transmittance(const std::vector<Material>& materials, const Media& media, double distance);

// The media behind a surface of that material, of those in front of it; `front`: seen from the front of the surface.
[[nodiscard]] Media behind(const std::vector<Material>& materials, std::size_t material, bool front,
                           const Media& media);

// The media on the two sides of a surface.
struct MediaPair {
    const Media& before; // on the side of the path
    const Media& beyond;
    bool front; // the path is at its front
};

// The model with its indices relative to the medium before the surface. `fromMedia`: a dielectric's index is that of
// the media on its two sides; else its own.
[[nodiscard]] MaterialModel relativeTo(const std::vector<Material>& materials, bool fromMedia, MaterialModel model,
                                       const MediaPair& sides);

// True if any dielectric has a priority.
[[nodiscard]] bool hasPriorities(const std::vector<Material>& materials);

} // namespace hyalite::reference
