// Light through several media: scenes of scenes/tests/media, whose heads derive the values.
#include "image/known_answer.h"
#include "scene/load/load_scene.h"

#include <catch2/catch_test_macros.hpp>
#include <filesystem>

namespace hyalite::testing {

namespace {

struct Known {
    std::string file;
    double radiance;
    std::vector<std::string_view> integrators;
};

const std::vector<std::string_view> kEvery{"whitted", "path", "ppm", "photonmap"};
// The media of a camera path are the same for all integrators that follow one direction: one of them is asked.
const std::vector<std::string_view> kOneOfEach{"whitted", "path"};
// The others bring the light of a point through glass as photons, blurred over their search radius.
const std::vector<std::string_view> kByShadowRays{"whitted", "path"};

const std::vector<Known>& knownScenes() {
    static const std::vector<Known> known{
        {"bubble", 0.11523, kOneOfEach},           {"nested-three", 0.39581, kOneOfEach},
        {"gold-under-water", 0.26312, kOneOfEach}, {"camera-in-water", 0.63769, kOneOfEach},
        {"light-in-smoke", 0.043078, kEvery},      {"thin-pane", 0.92027, kOneOfEach},
        {"priorities", 0.91405, kOneOfEach},       {"matched-shadow", 0.31831, kByShadowRays},
        {"thin-shadow", 0.29382, kByShadowRays},   {"touching", 0.91405, kEvery},
        {"touching-turned", 0.75535, kOneOfEach},  {"flush-bubble", 0.12473, kOneOfEach},
        {"water-in-tumbler", 0.91695, kOneOfEach}, {"smoke-on-floor", 0.11710, kByShadowRays},
    };
    return known;
}

} // namespace

TEST_CASE("light through nested, overlapping and thin dielectrics has the radiance of the closed forms") {
    std::size_t comparisons = 0;
    for (const Known& known : knownScenes()) {
        comparisons += renderersOf(known.integrators).size();
    }
    FalseAlarms alarms(comparisons);
    for (const Known& known : knownScenes()) {
        const Scene scene =
            loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes/tests/media" / (known.file + ".yaml"));
        for (const Renderer& renderer : renderersOf(known.integrators)) {
            INFO(known.file << ", " << renderer.name);
            // Where paths make no random decision, only the angles within the picture differ: by 1e-4
            const bool exact = renderer.integrator == "whitted";
            CHECK(judge(alarms, renderer, scene, everywhere(known.radiance), Independent::Pixels,
                        {.bias = 5e-4, .sees = exact ? 2e-3 : 0.15}));
        }
    }
}

TEST_CASE("clear dielectrics under a uniform sky show it, however they overlap and touch") {
    const std::string_view whitted[] = {"whitted"};
    for (const std::string_view file : {"ice-in-water.yaml", "overlapping.yaml"}) {
        const Scene scene = loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes/tests/media" / file);
        for (const Renderer& renderer : renderersOf(whitted)) {
            INFO(file << ", " << renderer.name);
            double sum = 0;
            const Image picture = renderBy(renderer, scene);
            for (const glm::vec3& pixel : picture.pixels) {
                CHECK(pixel.x < 1.0001F); // a leak gains or loses the squared index
                sum += double{pixel.x};
            }
            CHECK(sum / static_cast<double>(picture.pixels.size()) > 0.99); // the rest is still inside
        }
    }
}

} // namespace hyalite::testing
