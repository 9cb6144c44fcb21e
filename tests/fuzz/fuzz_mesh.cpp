// Mesh files of one format: OBJ, PLY or STL, selected by HYALITE_PARSE.
#include "fuzz/fuzz_input.h"
#include "scene/import/mesh_import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return hyalite::fuzz::expectAnswer(
        [&] { static_cast<void>(hyalite::HYALITE_PARSE(hyalite::fuzz::text(data, size), "mesh")); });
}
