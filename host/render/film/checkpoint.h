// A render's progress in a file, from which it can resume. Parts of one render, made on any machines, can be merged.
#pragma once

#include "render/film/counts.h"
#include "render/film/film_state.h"
#include "render/film/render_identity.h"

#include <filesystem>
#include <span>

namespace hyalite::render {

struct Checkpoint {
    RenderIdentity identity;
    FilmState film;
    Counts counts;      // over all its passes
    double seconds = 0; // time that its passes took [s]
};

// Writes atomically (writeFileAtomically). Throws Error(OutputNotWritten).
void writeCheckpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

// Throws Error(BadInput) if the file is not a checkpoint or is corrupt.
[[nodiscard]] Checkpoint readCheckpoint(const std::filesystem::path& path);

// The same for a file's content; `name` names the file in messages. Memory use is at most a small multiple of the
// content.
[[nodiscard]] Checkpoint parseCheckpoint(std::span<const std::byte> content, const std::string& name);

// Adds the passes of `part` to `whole`. Throws Error(BadInput), naming the part's file `name`, if they are from a
// different render or overlap.
void addCheckpoint(Checkpoint& whole, const Checkpoint& part, const std::string& name);

} // namespace hyalite::render
