// The list of integrators, and when each works: kernels run from prepare() on, not before.
#include "kernel/kernel_support.h"
#include "render/integrators/registry.h"
#include "scene/model/integrators.h"

#include <algorithm>

namespace hyalite::testing {

namespace {

class DispatchCounter final : public gpu::DispatchObserver {
public:
    void before(const gpu::Dispatch& /*dispatch*/) override { ++count; }
    void after(const gpu::Dispatch& /*dispatch*/) override {}
    int count = 0;
};

} // namespace

TEST_CASE("the registered integrators are those that scene files may name, in the same order") {
    CHECK(std::ranges::equal(render::integratorKinds(), kIntegrators, {}, &render::IntegratorKind::name,
                             &IntegratorRow::name));
    for (const render::IntegratorKind& kind : render::integratorKinds()) {
        Scene scene;
        scene.render.integrator = kind.name;
        CHECK(render::integratorKind(scene).name == kind.name);
        CHECK(kind.make != nullptr);
        CHECK(kind.reference != nullptr);
        CHECK_FALSE(kind.layers(scene.render).empty());
    }
    Scene scene;
    scene.render.integrator = "pmm";
    CHECK_THROWS_AS(render::integratorKind(scene), Error);
    CHECK(RenderSettings().integrator == kIntegrators.front().name);
}

TEST_CASE("a key of one integrator names it, a key of several or of all names none") {
    REQUIRE(soleReader("view") != nullptr);
    CHECK(soleReader("view")->name == "photonmap");
    CHECK(soleReader("photons") == nullptr);
    CHECK(soleReader("passes") == nullptr);
}

TEST_CASE("an integrator runs no kernel before it is prepared") {
    for (const render::IntegratorKind& kind : render::integratorKinds()) {
        INFO(kind.name);
        Scene scene = reference::test::cornellBox();
        scene.render.integrator = kind.name;
        scene.render.radius = 0; // ppm has to find it, and its caustic radius
        render::Device device(Gpu::shared().context(), Gpu::shared().compiler(), false);
        DispatchCounter dispatches;
        const gpu::Observation observation = device.commands.observe(dispatches);
        const render::DeviceScene deviceScene = render::uploadScene(device.context, device.tables, scene);
        render::Film film(device, scene.camera.resolution, kind.layers(scene.render));
        const auto integrator = kind.make({.device = device, .scene = scene, .deviceScene = deviceScene, .film = film});
        CHECK(dispatches.count == 0);
        if (kind.name == "ppm") {
            CHECK(integrator->notes().searchRadius == 0);
            integrator->prepare();
            CHECK(dispatches.count > 0);
            CHECK(integrator->notes().searchRadius > 0);
            CHECK(integrator->notes().causticSearchRadius > 0);
        }
        device.commands.finish();
    }
}

} // namespace hyalite::testing
