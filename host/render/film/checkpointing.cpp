#include "render/film/checkpointing.h"

#include <algorithm>
#include <utility>

namespace hyalite::render {

Checkpointing::Checkpointing(CheckpointOptions options, RenderIdentity identity)
    : options_(std::move(options)), identity_(std::move(identity)) {}

void Checkpointing::resume(Device& device, Film& film) {
    if (options_.file.empty() || !options_.resume || !std::filesystem::exists(options_.file)) {
        return;
    }
    Checkpoint found = readCheckpoint(options_.file);
    const auto sameLayer = [](const LayerKind& a, const LayerKind& b) { return a.name == b.name; };
    const std::string differs = difference(found.identity, identity_);
    if (!differs.empty() || found.film.resolution != film.resolution() ||
        !std::ranges::equal(found.film.layers, film.layers(), sameLayer)) {
        throw Error(ExitCode::BadInput, SourceLocation{options_.file.string()},
                    "checkpoint is from a different render: " + (differs.empty() ? "the layers differ" : differs),
                    "render with the same scene, settings and shaders, or name another --checkpoint");
    }
    film.restore(device, found.film);
    found.film.sums = {};
    before_ = std::move(found);
}

void Checkpointing::save(const Film& film, const Counts& counts, double seconds, bool now) {
    if (options_.file.empty() || film.passes().count() == 0 || (!now && sinceSaved_.seconds() < options_.every)) {
        return;
    }
    Checkpoint checkpoint{identity_, film.state(), before_.counts, before_.seconds + seconds};
    checkpoint.counts += counts;
    try {
        writeCheckpoint(options_.file, checkpoint);
        failure_.reset();
    } catch (const Error& error) {
        failure_ = error;
    }
    sinceSaved_ = Stopwatch();
}

} // namespace hyalite::render
