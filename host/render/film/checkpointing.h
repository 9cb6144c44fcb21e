// Maintains a render's checkpoint: resumes from it, writes it periodically and at the end.
#pragma once

#include "base/error.h"
#include "base/stopwatch.h"
#include "render/film/checkpoint.h"
#include "render/film/film.h"

#include <optional>

namespace hyalite::render {

struct CheckpointOptions {
    std::filesystem::path file; // empty: no checkpoint
    bool resume = false;        // resume from the file if it exists
    double every = 60;          // interval between writes [s]
};

class Checkpointing {
public:
    Checkpointing(CheckpointOptions options, RenderIdentity identity);

    // Fills an empty film with the file's sums. Throws Error(BadInput) if they are from a different render.
    void resume(Device& device, Film& film);

    // Call between passes: `counts` and `seconds` are those since resume(). Writes if it is time, or `now`. A failure
    // is kept for failure() and the write is retried next time: the render continues.
    void save(const Film& film, const Counts& counts, double seconds, bool now);

    [[nodiscard]] const std::optional<Error>& failure() const { return failure_; } // failure of the last save
    [[nodiscard]] const Counts& countsBefore() const { return before_.counts; }
    [[nodiscard]] double secondsBefore() const { return before_.seconds; }

private:
    CheckpointOptions options_;
    RenderIdentity identity_;
    Checkpoint before_; // the checkpoint resumed from, without its sums
    Stopwatch sinceSaved_;
    std::optional<Error> failure_;
};

} // namespace hyalite::render
