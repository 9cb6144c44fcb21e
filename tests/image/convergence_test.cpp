// Progressive photon mapping converges to the unbiased result of path tracing.
#include "image/known_answer.h"
#include "scene/load/load_scene.h"
#include "unit/reference/support.h"

#include <filesystem>

namespace hyalite::testing {

namespace {

constexpr int kBlocks = 2; // the picture is 2 x 2 blocks of 16 x 16 pixels

// Mean over the channels, block by block.
std::vector<double> blockMeans(const Image& image) {
    std::vector<double> means(std::size_t{kBlocks} * kBlocks, 0.0);
    const int size = image.width / kBlocks;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const glm::vec3 c = image.at(x, y);
            means[static_cast<std::size_t>(y / size) * kBlocks + static_cast<std::size_t>(x / size)] +=
                double{c.x + c.y + c.z} / (3 * size * size);
        }
    }
    return means;
}

Scene asShipped() {
    return loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes" / "cornell-caustics.yaml");
}

// The box of coats, metals and frosted glass, under a faint sky.
Scene glossy() {
    Scene scene = reference::test::cornellBox();
    scene.materials = {{.name = "white", .model = MetallicRoughness{{0.7, 0.6, 0.5}, 0, 0.4}},
                       {.name = "red", .model = Conductor{{0.2, 0.9, 1.1}, {3.9, 2.4, 2.1}, 0.5}},
                       {.name = "green", .model = MetallicRoughness{{0.2, 0.6, 0.4}, 0.6, 0.7}},
                       {.name = "metal", .model = Conductor{{1.6, 0.9, 0.5}, {9.2, 6.3, 4.8}, 0.3}},
                       {.name = "glass", .model = Dielectric{1.5, 0.3, {0, 0.5, 1}}}};
    scene.environment = Environment{.image = Image(1, 1), .scale = 0.3};
    scene.environment->image.pixels[0] = glm::vec3(1);
    return scene;
}

// A diffuse and a glass ball on a floor under a sky and a ball of light.
Scene outdoors() {
    Scene scene = reference::test::onePixel({0, 1.5, 5}, {0, 0.4, 0}, "ppm");
    scene.camera.fov = 40;
    const std::size_t floor = reference::test::addMaterial(scene, Diffuse{{0.6, 0.6, 0.5}});
    const std::size_t red = reference::test::addMaterial(scene, Diffuse{{0.7, 0.2, 0.1}});
    const std::size_t glass = reference::test::addMaterial(scene, Dielectric{1.5});
    reference::test::addObject(scene, Quad{{-3, 0, 3}, {6, 0, 0}, {0, 0, -6}}, floor);
    reference::test::addObject(scene, Sphere{{-0.8, 0.6, 0}, 0.6}, red);
    reference::test::addObject(scene, Sphere{{0.8, 0.6, 0}, 0.6}, glass);
    reference::test::addObject(scene, Sphere{{0, 4, 1}, 1}, std::nullopt, glm::dvec3(4));
    scene.environment = Environment{.image = Image(1, 1)};
    scene.environment->image.at(0, 0) = {0.5F, 0.7F, 1.0F};
    return scene;
}

} // namespace

TEST_CASE("the mean of progressive photon mapping is that of path tracing") {
    // Independent renders of both, block by block: the mean of their difference over path's mean is 0, except for the
    // bias of photon mapping. Where discs of radius r extend beyond an edge, up to a distance r from it, up to half of
    // the indirect light is missing: on average over that strip a fraction of 2 / (3 pi) = 0.21. For edges of length l
    // in an area A that is 0.21 r l / A of the indirect light. A block of these pictures covers about 1 m^2 per 2 m of
    // edge, so with r = 0.01 it loses less than 0.5 % of its indirect light; the curvature of the light within a disc,
    // r^2 / 8 times its second derivative, adds a hundredth of that.
    const std::vector<std::pair<std::string, Scene>> cases{
        {"default scene", asShipped()}, {"outdoors", outdoors()}, {"glossy", glossy()}};
    constexpr std::uint32_t kRenders = 16;
    constexpr std::size_t kAllBlocks = std::size_t{kBlocks} * kBlocks;
    FalseAlarms alarms(cases.size() * kAllBlocks);
    for (const auto& [name, shipped] : cases) {
        Scene scene = shipped;
        scene.camera.resolution = {32, 32};
        scene.render.maxDepth = 12;
        scene.render.radius = 0.01;
        scene.render.photons = 20000;
        scene.render.photonMap.causticPhotons = 20000;
        const auto blocks = [&](std::string_view integrator, std::uint32_t passes, std::uint32_t seed) {
            scene.render.passes = passes;
            scene.render.seed = seed;
            return blockMeans(renderBy({"", integrator, Backend::Reference}, scene));
        };
        std::vector<std::vector<double>> differences(kAllBlocks);
        std::vector<double> means(kAllBlocks, 0.0);
        for (std::uint32_t render = 1; render <= kRenders; ++render) {
            const std::vector<double> ppm = blocks("ppm", 8, render);
            const std::vector<double> path = blocks("path", 96, kRenders + render);
            for (std::size_t block = 0; block < kAllBlocks; ++block) {
                differences[block].push_back(ppm[block] - path[block]);
                means[block] += path[block] / kRenders;
            }
        }
        for (std::size_t block = 0; block < kAllBlocks; ++block) {
            INFO(name << ", block " << block);
            for (double& difference : differences[block]) {
                difference = 1 + difference / means[block];
            }
            CHECK(alarms.mean(differences[block], 1, {.bias = 0.005, .sees = 0.2}));
        }
    }
}

} // namespace hyalite::testing
