// Photon mapping in two passes, device against reference, setting by setting.
#include "parity/compare_pictures.h"
#include "scene/load/load_scene.h"
#include "scene/yaml/settings.h"

#include <filesystem>

namespace hyalite::testing {

namespace {

// The scene with photonmap's default settings, but for its size.
Scene smallScene(const std::string& file) {
    Scene scene = loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes" / file);
    scene.render.integrator = "photonmap";
    scene.camera.resolution = {48, 48};
    scene.render.passes = 4;
    scene.render.photons = 30000;
    scene.render.photonMap.causticPhotons = 30000;
    return scene;
}

} // namespace

// The k nearest photons are the same, unless the path of one of them diverged, or two are at the same distance to
// rounding: then a few estimates in a hundred differ, by 1 / k.
TEST_CASE("photonmap gives the reference's picture of the default scene, with every setting") {
    const char* const settings[] = {"gather_rays: 1",
                                    "gather_rays: 0",
                                    "gather_rays: 2, precomputed_irradiance: false, nearest: 50",
                                    "structure: grid, radius: 0.1",
                                    "shadow_photons: 8",
                                    "filter: gaussian, caustic_filter: gaussian, gather_rays: 0",
                                    "filter: cone, caustic_filter: none, gather_rays: 0",
                                    "differential_checking: true",
                                    "projection_map: false",
                                    "caustic_photons: 0",
                                    "view: global_map",
                                    "view: caustic_map",
                                    "view: radius",
                                    "view: photons"};
    for (const std::string setting : settings) {
        Scene scene = smallScene("cornell-caustics.yaml");
        for (std::size_t at = 0; at < setting.size();) {
            const std::size_t colon = setting.find(": ", at);
            const std::size_t end = std::min(setting.find(", ", at), setting.size());
            applySetting(scene, "render." + setting.substr(at, colon - at), setting.substr(colon + 2, end - colon - 2));
            at = end + 2;
        }
        INFO(setting);
        comparePictures("photonmap-cornell", scene, 0.97);
    }
}

TEST_CASE("photonmap gives the reference's picture under every kind of light") {
    comparePictures("photonmap-lights", smallScene("tests/all-lights.yaml"), 0.97);
}

TEST_CASE("photonmap gives the reference's picture of every shape") {
    // Photons that graze one of many curved mirrors and panes of glass land elsewhere
    comparePictures("photonmap-shapes", smallScene("tests/all-shapes.yaml"), 0.95);
}

} // namespace hyalite::testing
