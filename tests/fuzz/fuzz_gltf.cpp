// glTF, as JSON or binary. Referenced files are looked up in an empty folder.
#include "fuzz/fuzz_input.h"
#include "scene/import/gltf_import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const hyalite::fuzz::InputFile folder("mesh.gltf");
    return hyalite::fuzz::expectAnswer([&] {
        const std::filesystem::path empty = folder.write({}).parent_path();
        static_cast<void>(hyalite::mergeParts(hyalite::parseGltf(hyalite::fuzz::text(data, size), "mesh", empty)));
    });
}
