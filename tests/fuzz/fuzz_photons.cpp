// Photon map files, with and without a matching checksum.
#include "fuzz/fuzz_input.h"
#include "render/photons/photon_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace hyalite;
    const render::RenderIdentity identity;
    fuzz::expectAnswer(
        [&] { static_cast<void>(render::parsePhotons(std::as_bytes(std::span(data, size)), "maps", identity)); });
    return fuzz::expectAnswer(
        [&] { static_cast<void>(render::parsePhotons(fuzz::withChecksum(data, size), "maps", identity)); });
}
