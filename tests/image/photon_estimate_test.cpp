// Density estimates where they are hard: under floors, in a focus, on a caustic far smaller than the scene, and at
// smoothed normals. On both sides, by ppm and photonmap, against values derived on paper.
#include "image/known_answer.h"
#include "scene/load/load_scene.h"
#include "unit/reference/support.h"

#include <array>
#include <filesystem>
#include <numbers>

namespace hyalite::testing {

namespace {

using glm::dvec3;
using std::numbers::pi;

Scene load(const char* name) {
    return loadScene(std::filesystem::path(HYALITE_SOURCE_DIR) / "scenes/tests" / name);
}

std::vector<Renderer> photonRenderers() {
    constexpr std::array<std::string_view, 2> names{"ppm", "photonmap"};
    return renderersOf(names);
}

double meanOf(const Image& image) {
    double sum = 0;
    for (const glm::vec3& pixel : image.pixels) {
        sum += double{pixel.x};
    }
    return sum / static_cast<double>(image.pixels.size());
}

double largestOf(const Image& image) {
    double largest = 0;
    for (const glm::vec3& pixel : image.pixels) {
        largest = std::max(largest, double{pixel.x});
    }
    return largest;
}

// The scene's lengths times `factor`, and its irradiance as it is. Only what these scenes have.
Scene scaled(Scene scene, double factor) {
    scene.camera.position *= factor;
    scene.camera.lookAt *= factor;
    for (DirectionalLight& light : scene.directionals) {
        if (light.beam) {
            light.beam->center *= factor;
            light.beam->radius *= factor;
        }
    }
    for (Object& object : scene.objects) {
        if (auto* quad = std::get_if<Quad>(&object.shape)) {
            *quad = {quad->corner * factor, quad->edge0 * factor, quad->edge1 * factor};
        } else if (auto* sphere = std::get_if<Sphere>(&object.shape)) {
            *sphere = {sphere->center * factor, sphere->radius * factor};
        } else {
            FAIL("a shape that this test does not scale");
        }
    }
    return scene;
}

// Mean of f over the ground y = 0 within `radius` of the origin, by the area of the ground that pixels see.
double meanOnGround(const Scene& scene, const Image& image, double radius) {
    constexpr int kParts = 4; // subsamples of a pixel, along each side
    const dvec3 forward = glm::normalize(scene.camera.lookAt - scene.camera.position);
    const dvec3 right = glm::normalize(glm::cross(forward, scene.camera.up));
    const dvec3 up = glm::cross(right, forward);
    const double tangent = std::tan(scene.camera.fov / 2 * pi / 180);
    double sum = 0;
    double area = 0;
    for (int row = 0; row < kParts * image.height; ++row) {
        for (int column = 0; column < kParts * image.width; ++column) {
            const double sx = 2 * (column + 0.5) / (kParts * image.width) - 1;
            const double sy = 1 - 2 * (row + 0.5) / (kParts * image.height);
            const dvec3 way = forward + tangent * (sx * right + sy * up);
            const double t = -scene.camera.position.y / way.y;
            if (glm::length(scene.camera.position + t * way) <= radius) {
                const double seen = t * t * t; // area per part: t^2 / cos, with cos in proportion to 1 / t
                sum += seen * double{image.at(column / kParts, row / kParts).x};
                area += seen;
            }
        }
    }
    return sum / area;
}

// Mean radiance within two thirds of a radius of the axis on a ground of albedo 1/2 three radii below a ball of glass
// in a vertical beam of irradiance 1: see scenes/tests/caustic-on-large-ground.yaml.
double causticOfBall() {
    const int rings = 100000;
    double flux = 0; // for a ball of radius 1 [W]
    for (int i = 0; i < rings; ++i) {
        const double h = (i + 0.5) / rings;
        const double in = std::asin(h);
        const double out = std::asin(h / 1.5);
        const double d = 2 * (in - out);
        if ((3 - h / std::sin(d)) * std::tan(d) > 2.0 / 3) {
            break;
        }
        const double rs = (std::cos(in) - 1.5 * std::cos(out)) / (std::cos(in) + 1.5 * std::cos(out));
        const double rp = (1.5 * std::cos(in) - std::cos(out)) / (1.5 * std::cos(in) + std::cos(out));
        const double F = (rs * rs + rp * rp) / 2;
        flux += 2 * pi * h / rings * (1 - F) * (1 - F);
    }
    return 0.5 / pi * flux / (pi * 4 / 9);
}

void checkCaustic(const Scene& scene, double size) {
    for (const Renderer& renderer : photonRenderers()) {
        INFO(renderer.name);
        // Some 33 000 photons land there by ppm, 8 300 by photonmap: 0.5 % and 1.1 % at random, evenly spread ones less
        CHECK(std::abs(meanOnGround(scene, renderBy(renderer, scene), 0.02 * size) / causticOfBall() - 1) < 0.02);
    }
}

// The caustic alone: the shadow of the ball hides the direct light there.
Scene causticOnGround() {
    Scene scene = load("caustic-on-large-ground.yaml");
    scene.render.photonMap.gatherRays = 0;
    return scene;
}

Quad square(double half) {
    return {{-half, 0, -half}, {0, 0, 2 * half}, {2 * half, 0, 0}};
}

} // namespace

TEST_CASE("the caustic of a ball is the same on grounds from ten to a hundred thousand times its size") {
    for (const double half : {0.3, 3000.0}) {
        Scene scene = causticOnGround();
        scene.objects[0].shape = square(half);
        INFO("ground of " << half << " m");
        checkCaustic(scene, 1);
    }
}

TEST_CASE("the caustic of a ball is the same in millimetres and in kilometres, and on four tiles") {
    checkCaustic(scaled(causticOnGround(), 1e-3), 1e-3);
    checkCaustic(scaled(causticOnGround(), 1e3), 1e3);
    Scene tiled = causticOnGround();
    const Object ground = tiled.objects[0];
    tiled.objects.erase(tiled.objects.begin());
    for (const dvec3 corner :
         {dvec3(-0.5, 0, -0.5), dvec3(0.005, 0, -0.5), dvec3(-0.5, 0, 0.003), dvec3(0.005, 0, 0.003)}) {
        tiled.objects.push_back(ground);
        tiled.objects.back().shape =
            Quad{corner, {0, 0, corner.z < 0 ? 0.503 : 0.497}, {corner.x < 0 ? 0.505 : 0.495, 0, 0}};
    }
    checkCaustic(tiled, 1);
}

TEST_CASE("all light of a burning mirror is in its focus") {
    // The pixels see L = albedo E / pi: the mean over the picture is flux / pi times cos / d^2 at the disk over the
    // picture's solid angle. 64 passes find the spot in a few pixels some 100 times. Around
    // it, k nearest of n photons that all lie in the spot add 2 k / n ln 4 of the flux within four pixels: 0.7 %.
    Scene scene = load("burning-mirror.yaml");
    const double distance = glm::length(scene.camera.position - scene.camera.lookAt);
    const double side = 2 * std::tan(scene.camera.fov / 2 * pi / 180);
    const double flux = pi * (0.4 * 0.4 - 0.03 * 0.03);
    const double expected = flux / pi * (0.4 / distance) / (distance * distance) / (side * side);
    for (const Renderer& renderer : photonRenderers()) {
        scene.render.photonMap.causticPhotons = renderer.integrator == "ppm" ? 2000 : 20000;
        INFO(renderer.name);
        CHECK(std::abs(meanOf(renderBy(renderer, scene)) / expected - 1) < 0.02);
    }
}

TEST_CASE("no photon or record of a lit ground counts on the floor above it") {
    const Scene room = load("leak-under-floor.yaml");
    // The floor is 5 cm thick
    for (const auto& [under, structure] :
         {std::pair{0.1, PhotonStructure::Tree}, std::pair{0.051, PhotonStructure::Grid}}) {
        Scene scene = room;
        scene.render.photonMap.structure = structure;
        scene.objects[0].shape = Quad{{-5, -under, -5}, {0, 0, 10}, {10, 0, 0}};
        for (const Renderer& renderer : photonRenderers()) {
            INFO(renderer.name << ", ground " << under << " below the floor");
            CHECK(largestOf(renderBy(renderer, scene)) == 0);
        }
    }
}

TEST_CASE("photons count by the cosine at the smoothed normal, as light sampled directly does") {
    const Scene tilted = load("tilted-normals.yaml");
    for (const Renderer& renderer : photonRenderers()) {
        Scene scene = tilted;
        scene.render.photonMap.gatherRays = 0; // photons that the floor reflects come back by the mirror
        scene.render.maxDepth = 3;
        INFO(renderer.name);
        CHECK(std::abs(meanOf(renderBy(renderer, scene)) / 0.5 - 1) < 0.02);
    }
}

} // namespace hyalite::testing
