// What a render has done so far, in a file that it can go on from. Parts of one render, wherever they were made, add
// up.
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
    double seconds = 0; // that its passes took
};

// In one step (writeFileAtomically). Throws Error(OutputNotWritten).
void writeCheckpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

// Throws Error(BadInput) for what is no checkpoint or is damaged.
[[nodiscard]] Checkpoint readCheckpoint(const std::filesystem::path& path);

// The same of a file's content; `name` is the file in messages. Takes no more memory than some times the content.
[[nodiscard]] Checkpoint parseCheckpoint(std::span<const std::byte> content, const std::string& name);

// Adds the passes of `part` to `whole`. Throws Error(BadInput), naming the file `name` of the part, where they are of
// another render or overlap.
void addCheckpoint(Checkpoint& whole, const Checkpoint& part, const std::string& name);

} // namespace hyalite::render
