// Scene files, and the settings of the command line: all of YAML.
#include "fuzz/fuzz_input.h"
#include "scene/load/load_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const hyalite::fuzz::InputFile file("scene.yaml");
    return hyalite::fuzz::expectAnswer(
        [&] { static_cast<void>(hyalite::loadScene(file.write(hyalite::fuzz::text(data, size)))); });
}
