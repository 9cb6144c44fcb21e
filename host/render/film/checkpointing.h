// Keeps a render's checkpoint: goes on from it at first, writes it now and then and at the end.
#pragma once

#include "base/error.h"
#include "base/stopwatch.h"
#include "render/film/checkpoint.h"
#include "render/film/film.h"

#include <optional>

namespace hyalite::render {

struct CheckpointOptions {
    std::filesystem::path file; // empty: none is kept
    bool resume = false;        // go on from the file, where it is there
    double every = 60;          // write it after so many seconds [s]
};

class Checkpointing {
public:
    Checkpointing(CheckpointOptions options, RenderIdentity identity);

    // Fills an empty film with what the file holds. Throws Error(BadInput) where that is of another render.
    void resume(Device& device, Film& film);

    // Between passes: `counts` and `seconds` are those since resume(). Writes where it is time, or `now`. A failure is
    // kept for failure() and tried again next time: the render goes on.
    void save(const Film& film, const Counts& counts, double seconds, bool now);

    [[nodiscard]] const std::optional<Error>& failure() const { return failure_; } // of the last save
    [[nodiscard]] const Counts& countsBefore() const { return before_.counts; }
    [[nodiscard]] double secondsBefore() const { return before_.seconds; }

private:
    CheckpointOptions options_;
    RenderIdentity identity_;
    Checkpoint before_; // resumed from; without its sums
    Stopwatch sinceSaved_;
    std::optional<Error> failure_;
};

} // namespace hyalite::render
