// Queues whose sizes only the device knows: pictures and counts are those of a host that looks at every bounce.
#include "gpu/dispatch_observer.h"
#include "kernel/kernel_support.h"
#include "render/photons/photon_paths.h"
#include "render/renderer.h"

#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>

namespace hyalite::testing {

namespace {

// Sees every dispatch, and so has the host wait for each.
struct Watcher : gpu::DispatchObserver {
    std::map<std::string, std::uint64_t> threads; // by kernel
    void before(const gpu::Dispatch& dispatch) override { threads[dispatch.kernel.name()] += dispatch.threads; }
    void after(const gpu::Dispatch& /*dispatch*/) override {}
};

render::RenderResult renderWatched(const Scene& scene, Watcher* watcher,
                                   const gpu::Context& context = Gpu::shared().context()) {
    gpu::Observation observation;
    render::RenderOptions options;
    options.onUpload = [&](render::Device& device, const render::DeviceScene&) {
        if (watcher != nullptr) {
            observation = device.commands.observe(*watcher);
        }
    };
    return render::render(context, Gpu::shared().compiler(), scene, options);
}

Scene smallBox(Integrator integrator) {
    Scene scene = roughBox();
    scene.camera.resolution = {24, 16};
    scene.render.integrator = integrator;
    scene.render.passes = 3;
    scene.render.photons = 3000;
    scene.render.maxDepth = integrator == Integrator::Whitted ? 4 : 20; // more bounces than are recorded at once
    scene.render.photonMap.causticPhotons = 2000;
    return scene;
}

const std::array kIntegrators{Integrator::Ppm, Integrator::PhotonMap, Integrator::Path, Integrator::Whitted};

std::vector<std::uint64_t> numbersOf(const render::Counts& counts) {
    std::vector<std::uint64_t> numbers;
    for (const render::CounterRow& row : render::kCounters) {
        numbers.push_back(counts[row.counter]);
    }
    return numbers;
}

} // namespace

TEST_CASE("queues on the device give the picture and the counts of a host that looks at every bounce") {
    const Scene scene = smallBox(kIntegrators.at(GENERATE(range(0U, 4U))));
    CAPTURE(scene.render.integrator);
    Watcher watcher;
    const render::RenderResult watched = renderWatched(scene, &watcher);
    const render::RenderResult free = renderWatched(scene, nullptr);
    CHECK(free.image.picture.pixels == watched.image.picture.pixels);
    CHECK(numbersOf(free.counts) == numbersOf(watched.counts));
    if (scene.render.integrator != Integrator::Whitted) {
        // Each thread of shade_surface is a camera ray, each of the kernels at photons' hits a photon ray
        CHECK(free.counts[render::Counter::CameraRays] == watcher.threads["shade_surface"]);
        CHECK(free.counts[render::Counter::PhotonRays] <=
              watcher.threads["scatter_photon"] + watcher.threads["cast_shadow_photons"]);
    }
}

TEST_CASE("memory that the host does not see gives the same pictures and counts") {
    gpu::ContextOptions options;
    options.staged = true;
    const gpu::Context staged(options);
    const Scene scene = smallBox(kIntegrators.at(GENERATE(range(0U, 4U))));
    CAPTURE(scene.render.integrator);
    const render::RenderResult expected = renderWatched(scene, nullptr);
    const render::RenderResult result = renderWatched(scene, nullptr, staged);
    CHECK(result.image.picture.pixels == expected.image.picture.pixels);
    CHECK(numbersOf(result.counts) == numbersOf(expected.counts));
}

TEST_CASE("photons that need more slots than those before are followed again, and counted once") {
    const Scene scene = reference::test::cornellBox();
    const auto sequence = [&](std::uint32_t pass) {
        return shared::photonSequence(shared::renderSeed(1, shared::kSobolNumbers), shared::kGlobalPhotons, pass);
    };
    // Direct photons alone end at the first surface; then all kinds go on from there
    const render::PhotonPass brief{.sequence = sequence(0), .count = 2000, .kinds = 1U << shared::kPhotonDirect};
    const render::PhotonPass full{.sequence = sequence(1),
                                  .count = 2000,
                                  .kinds = 1U << shared::kPhotonDirect | 1U << shared::kPhotonIndirect |
                                           1U << shared::kPhotonCaustic};
    BothSides both(scene);
    render::PhotonPaths alone(both.device, both.scene, both.deviceScene, 2000);
    const std::uint32_t slots = alone.trace(full);
    render::PhotonPaths grown(both.device, both.scene, both.deviceScene, 2000);
    const std::uint32_t slotsOfBrief = grown.trace(brief);
    const std::uint64_t raysOfBrief = grown.raysTraced();
    REQUIRE(2 * slotsOfBrief < slots);
    REQUIRE(grown.photons().count() < slots);
    CHECK(grown.trace(full) == slots);
    CHECK(grown.raysTraced() - raysOfBrief == alone.raysTraced());
    const auto expected = alone.photons().read(0, slots);
    const auto found = grown.photons().read(0, slots);
    for (std::size_t i = 0; i < slots; ++i) {
        REQUIRE(found[i].surface == expected[i].surface);
        REQUIRE((found[i].surface == shared::kNone || found[i].position == expected[i].position));
    }
}

TEST_CASE("a tree of rays that outgrows those of the passes before is traced again, and counted once") {
    // One pixel whose rays meet a small glass ball or pass beside it: in some passes, the tree has one ray, in others
    // many
    Scene scene = reference::test::onePixel({0, 0, 3}, {0, 0, 0}, Integrator::Whitted);
    scene.camera.fov = 40; // the pixel shows 2.2 m at the ball's distance
    scene.render.maxDepth = 5;
    reference::test::addMaterial(scene, Dielectric{1.5});
    reference::test::addMaterial(scene, Diffuse{dvec3(0.5)});
    reference::test::addObject(scene, Sphere{{0, 0, 0}, 0.6}, 0);
    reference::test::addObject(scene, Quad{{-5, -5, -2}, {10, 0, 0}, {0, 10, 0}}, 1);
    scene.lights = {{{0, 4, 2}, {10, 10, 10}}};
    scene.render.passes = 24;
    Watcher watcher;
    const render::RenderResult watched = renderWatched(scene, &watcher);
    const render::RenderResult free = renderWatched(scene, nullptr);
    CHECK(free.image.picture.pixels == watched.image.picture.pixels);
    CHECK(numbersOf(free.counts) == numbersOf(watched.counts));
    CHECK(free.counts[render::Counter::CameraRays] > 24); // some met glass
}

TEST_CASE("a shadow ray is counted where light may come from, and nowhere else") {
    // A plane that faces the camera and fills half of the picture: of 16 x 16 pixels, 8 rows. The rest shows nothing.
    const auto shadowRays = [](Integrator integrator, const dvec3& light) {
        Scene scene = reference::test::onePixel({0, 0, 2}, {0, 0, 0}, integrator);
        scene.camera.resolution = {16, 16};
        scene.camera.fov = 60;
        scene.render.passes = 1;
        scene.render.photons = 64;
        scene.render.maxDepth = 2;
        scene.render.photonMap.shadowPhotons = 0;
        reference::test::addMaterial(scene, Diffuse{dvec3(0.5)});
        reference::test::addObject(scene, Quad{{-9, -18, 0}, {18, 0, 0}, {0, 18, 0}}, 0); // y <= 0
        scene.lights = {{light, {1, 1, 1}}};
        return renderWatched(scene, nullptr).counts[render::Counter::ShadowRays];
    };
    const Integrator integrator = kIntegrators.at(GENERATE(range(0U, 4U)));
    CAPTURE(integrator);
    // No jitter crosses a row's edge, and y = 0 is the edge between rows 7 and 8
    CHECK(shadowRays(integrator, {0, -1, 3}) == 16 * 8);
    CHECK(shadowRays(integrator, {0, -1, -3}) == 0); // behind the plane: no light comes to its front
}

} // namespace hyalite::testing
