// Observed inputs of dispatches, and single paths on both sides.
#include "parity/inspection_session.h"
#include "parity/observed.h"
#include "render/integrators/registry.h"
#include "scene/load/load_scene.h"
#include "scene/model/integrators.h"
#include "support/gpu_fixture.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <catch2/catch_test_macros.hpp>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace hyalite::testing {

namespace {

// A scene on the device.
struct Uploaded {
    Scene scene;
    render::Device device{Gpu::shared().context(), Gpu::shared().compiler(), false};
    render::DeviceScene deviceScene;
    parity::InspectionSession session;

    explicit Uploaded(std::string_view integrator)
        : scene(small(integrator)), deviceScene(render::uploadScene(device.context, device.tables, scene)),
          session(device, scene, deviceScene) {}

    [[nodiscard]] static Scene small(std::string_view integrator) {
        Scene scene = loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes/cornell-caustics.yaml");
        scene.camera.resolution = {16, 16};
        scene.render.integrator = integrator;
        scene.render.photons = 512;
        scene.render.photonMap.causticPhotons = 512;
        scene.render.radius = 0.1; // and below: so that no photons but those of the pass are traced
        scene.render.photonMap.causticRadius = 0.1;
        return scene;
    }

    void renderPass(std::uint32_t pass) {
        const render::IntegratorKind& kind = render::integratorKind(scene);
        render::Film film(device, scene.camera.resolution, kind.layers(scene.render));
        const auto integrator = kind.make({.device = device, .scene = scene, .deviceScene = deviceScene, .film = film});
        integrator->prepare();
        integrator->begin();
        film.beginPass(pass);
        integrator->renderPass(pass);
        device.commands.finish();
    }
};

bool areEqual(const parity::Vertex& a, const parity::Vertex& b) {
    return a.depth == b.depth && a.seed == b.seed && a.object == b.object && a.position == b.position &&
           a.weight == b.weight && a.choice == b.choice;
}

} // namespace

TEST_CASE("a dispatch covers the number of elements given by the host or counted on the device before it") {
    const Gpu& gpu = Gpu::shared();
    render::Device device(gpu.context(), gpu.compiler(), false);
    const gpu::Array<shared::uint> counted(gpu.context(), std::vector<shared::uint>{7, 9}, "counted");
    shared::ScanGroupArguments arguments{};
    arguments.values = counted;
    arguments.sums = counted;
    arguments.count = 2;
    const gpu::Kernel kernel = device.kernel("scan_group");
    const parity::Observed seen(gpu.context(), device.tables,
                                {kernel, std::as_bytes(std::span(&arguments, 1)), shared::kGroupSize});
    counted.write(std::vector<shared::uint>{0, 0}); // as the kernel might
    const auto read = seen.arguments<shared::ScanGroupArguments>();
    CHECK(seen.count(read.count) == 2);
    CHECK(seen.count(read.values) == 7);
    CHECK(seen.count(shared::UintArray{}) == 0); // nothing there
}

TEST_CASE("a path followed alone equals that path among all paths of its pass") {
    const auto agree = [](const parity::RecordedPath& alone, const parity::RecordedPath& among) {
        REQUIRE_FALSE(alone.device.empty());
        REQUIRE(alone.device.size() == among.device.size());
        REQUIRE(alone.twin.size() == among.twin.size());
        for (std::size_t i = 0; i < alone.device.size(); ++i) {
            CHECK(areEqual(alone.device[i], among.device[i]));
        }
        CHECK(alone.differsAt == among.differsAt);
    };
    constexpr std::uint32_t kPixel = 11 * 16 + 7; // on a ball
    for (const std::string_view integrator : kIntegratorNames) {
        INFO(integrator);
        Uploaded uploaded(integrator);
        gpu::Observation observation = uploaded.session.watch({"none of the kernels"});
        uploaded.renderPass(0);
        observation.end();
        agree(uploaded.session.followPixel(kPixel, 0), uploaded.session.path({false, 0, kPixel}));
        if (integratorNamed(integrator).reads("photons")) {
            for (const bool isCaustic : {false, true}) {
                const auto alone = uploaded.session.followPhoton({.number = 5, .isCaustic = isCaustic}, 0);
                agree(alone, uploaded.session.path(alone.key));
            }
        } else {
            CHECK_THROWS_AS(uploaded.session.followPhoton({.number = 5}, 0), Error);
        }
    }
}

TEST_CASE("however the recording of a path ends, no observer stays registered") {
    struct Impatient : gpu::DispatchObserver {
        int left = 3;
        void before(const gpu::Dispatch& /*dispatch*/) override {
            if (left-- == 0) {
                throw 7; // no Error
            }
        }
        void after(const gpu::Dispatch& /*dispatch*/) override {}
        [[nodiscard]] bool readsBuffers() const override { return false; }
    };
    Uploaded uploaded("ppm");
    {
        Impatient impatient;
        const gpu::Observation observation = uploaded.device.commands.observe(impatient);
        CHECK_THROWS_AS(uploaded.session.followPixel(0, 0), int);
        CHECK_FALSE(uploaded.device.commands.areBuffersRead()); // the session's observer would
    }
    CHECK_FALSE(uploaded.session.followPixel(0, 0).device.empty());
}

} // namespace hyalite::testing
