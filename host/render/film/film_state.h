// The state of a film: its passes, their exact sums, and its faults. Films of one picture can be added.
#pragma once

#include "image/layered_image.h"

#include "shaders/shared/film.h"
#include "shaders/shared/random.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hyalite::render {

struct PassRange {
    std::uint32_t begin = 0;
    std::uint32_t end = 0; // > begin; exclusive

    friend bool operator==(const PassRange&, const PassRange&) = default;
};

class PassSet {
public:
    PassSet() = default;
    explicit PassSet(const std::vector<PassRange>& ranges) {
        for (const PassRange& range : ranges) {
            add(range);
        }
    }

    // Adds a range of passes that are not in the set yet.
    void add(PassRange range);

    [[nodiscard]] bool contains(std::uint32_t pass) const;
    [[nodiscard]] std::optional<PassRange> common(const PassRange& range) const; // the first range of common passes
    [[nodiscard]] std::uint32_t count() const;
    [[nodiscard]] std::uint32_t countWithin(const PassRange& range) const;
    [[nodiscard]] std::uint32_t count(std::uint32_t sequence) const; // number of passes of one camera sequence
    [[nodiscard]] const std::vector<PassRange>& ranges() const { return ranges_; } // ascending, with gaps between
    [[nodiscard]] std::string text() const;                                        // "0:64, 128:192"

private:
    std::vector<PassRange> ranges_;
};

// Invalid values of one kind in one layer.
struct FilmFault {
    std::uint64_t count = 0;
    std::uint32_t pass = 0;  // the first pass with one
    std::uint32_t pixel = 0; // the lowest in that pass
};

struct FilmState {
    glm::uvec2 resolution{0};
    std::vector<LayerKind> layers;
    PassSet passes;
    std::vector<FilmFault> faults;                                             // layer after layer, kFilmFaults each
    std::array<std::vector<shared::FilmColor>, shared::kCameraSequences> sums; // layer after layer
    std::vector<std::uint32_t> sought;                                         // by pixel, 0 or 1: see Film::sought
};

// Adds the faults `more` to `fault`.
void addFault(FilmFault& fault, const FilmFault& more);

// Adds the passes of `part`, a film of the same resolution and layers; `film` must have none of these passes.
void addFilm(FilmState& film, const FilmState& part);

// A sentence for each layer and kind of fault. `command`, a hyalite inspect, renders the picture again.
[[nodiscard]] std::vector<std::string> faultWarnings(const std::vector<FilmFault>& faults,
                                                     const std::vector<LayerKind>& layers, glm::uvec2 resolution,
                                                     const std::string& command);

} // namespace hyalite::render
