// Checkpoints, with and without a matching checksum; a checkpoint that is read is merged with itself.
#include "fuzz/fuzz_input.h"
#include "render/film/checkpoint.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace hyalite;
    fuzz::expectAnswer(
        [&] { static_cast<void>(render::parseCheckpoint(std::as_bytes(std::span(data, size)), "kept")); });
    return fuzz::expectAnswer([&] {
        render::Checkpoint whole = render::parseCheckpoint(fuzz::withChecksum(data, size), "kept");
        const render::Checkpoint part = whole;
        render::addCheckpoint(whole, part, "kept"); // overlaps
        std::abort();
    });
}
