// The page's renderer on the device: kernels compiled on a change of the view, and interruption of passes.
#include "live/worker/live_renderer.h"
#include "support/gpu_fixture.h"
#include "unit/gpu/temporary_shaders.h"

#include <catch2/catch_test_macros.hpp>

using namespace hyalite;
using namespace hyalite::live;
using testing::Gpu;
using testing::TemporaryShaders;
using testing::writeFile;

namespace {

// A floor and a wall, and the folder that its files are in.
struct Studio {
    TemporaryShaders folder;
    Pulse pulse;
    bool isUnwanted = false; // the present pass
    ReloadingCompiler compiler{
        folder.shaders(), HYALITE_TEST_CACHE, {}, {}, [](const std::string&, const std::string&) {}};
    LiveRenderer renderer{Gpu::shared().context(), compiler, pulse, [this] { return isUnwanted; }};

    [[nodiscard]] std::filesystem::path saveScene(const std::string& name, const std::string& render) const {
        const std::filesystem::path file = folder.root() / name;
        writeFile(file, "hyalite: 1\n"
                        "camera: {position: [0, 3, 4], look_at: [0, 0, 0], resolution: [8, 8]}\n"
                        "render: {integrator: photonmap, photons: 2000, passes: 2, radius: 0.5" +
                            render +
                            "}\n"
                            "materials:\n"
                            "  gray: {type: diffuse, albedo: 0.5}\n"
                            "lights:\n"
                            "  - {type: point, position: [0, 2, 1], intensity: 10}\n"
                            "objects:\n"
                            "  - {shape: {type: quad, corner: [-5, 0, -5], edges: [[0, 0, 10], [10, 0, 0]]}, material: "
                            "gray}\n"
                            "  - {shape: {type: quad, corner: [-5, 0, -1], edges: [[10, 0, 0], [0, 5, 0]]}, material: "
                            "gray}\n");
        return file;
    }
    std::vector<glm::vec3> picture() {
        renderer.begin(/*isPreview*/ false);
        renderer.renderPass();
        return renderer.frame().image.picture.pixels;
    }
};

} // namespace

TEST_CASE("a filter file that the page sets is compiled, as one of the scene file is", "[live]") {
    Studio studio;
    writeFile(studio.folder.root() / "narrow.glsl", "float narrow(float u) {\n    return u < 0.1 ? 5.0 : 0.01;\n}\n");
    const auto withFilter = studio.saveScene("with.yaml", ", filter: custom, filter_file: narrow.glsl");
    const auto without = studio.saveScene("without.yaml", "");
    studio.renderer.load(withFilter, {});
    const std::vector<glm::vec3> expected = studio.picture();
    studio.renderer.load(without, {});
    CHECK(studio.picture() != expected);
    // Named relative to the scene file, as in it
    studio.renderer.look({.settings = {{"render.filter_file", "narrow.glsl"}, {"render.filter", "custom"}}});
    CHECK(studio.picture() == expected);
    studio.renderer.look({});
    CHECK(studio.picture() != expected);
}

TEST_CASE("a filter file that the page sets and that does not exist is refused, and the former view stays", "[live]") {
    Studio studio;
    studio.renderer.load(studio.saveScene("room.yaml", ""), {});
    try {
        studio.renderer.look({.settings = {{"render.filter_file", "gone.glsl"}}});
        FAIL("accepted");
    } catch (const Error& error) {
        CHECK(error.where().file == "page");
        CHECK(error.message().find("gone.glsl") != std::string::npos);
    }
    CHECK(studio.renderer.view().settings.empty());
}

TEST_CASE("a picture whose first pass fails is abandoned, and the next one renders", "[live]") {
    Studio studio;
    studio.renderer.load(studio.saveScene("room.yaml", ""), {});
    const std::string good = testing::readFile(studio.folder.shaders() / "kernels/emit_photons.comp");
    studio.folder.write("kernels/emit_photons.comp", "#version 460\nno kernel\n");
    CHECK_THROWS_AS(studio.picture(), Error);
    studio.renderer.drop(); // runs what was recorded before the error: its buffers must be there
    studio.folder.write("kernels/emit_photons.comp", good);
    studio.renderer.forget(studio.compiler.takeChanged());
    studio.renderer.forget({"emit_photons"});
    CHECK_FALSE(studio.picture().empty());
}

TEST_CASE("a pass can be interrupted after a pixel's inspection has failed", "[live]") {
    Studio studio;
    studio.renderer.load(studio.saveScene("room.yaml", ""), {});
    studio.renderer.look({.settings = {}, .shown = "normals"});
    studio.folder.write("kernels/shade_surface.comp",
                        "#version 460\nno kernel\n"); // inspection needs it, normals do not
    studio.renderer.begin(/*isPreview*/ false);
    CHECK_THROWS_AS(studio.renderer.inspect(0), Error);
    studio.isUnwanted = true;
    CHECK_THROWS_AS(studio.renderer.renderPass(), Interrupted);
    studio.isUnwanted = false;
    studio.renderer.drop();
    CHECK_FALSE(studio.picture().empty());
}
