// Photon maps with analytically known light, on the device and in the reference.
#include "kernel/kernel_support.h"
#include "reference/photons/photons.h"
#include "render/integrators/registry.h"
#include "render/photons/photon_paths.h"
#include "render/photons/photon_slots.h"
#include "render/renderer.h"

#include <numeric>

namespace hyalite::testing {

namespace {

using std::numbers::pi;

LayeredImage onDevice(const Scene& scene) {
    return render::render(Gpu::shared().context(), Gpu::shared().compiler(), scene, {}).image;
}

double meanOf(const Image& image) {
    double sum = 0;
    for (const vec3& pixel : image.pixels) {
        sum += pixel.x;
    }
    return sum / static_cast<double>(image.pixels.size());
}

const Image& layer(const LayeredImage& image, const std::string& name) {
    for (const NamedImage& l : image.layers) {
        if (l.name == name) {
            return l.image;
        }
    }
    FAIL("no layer " << name);
    return image.picture;
}

// A diffuse sphere of radius 1 and albedo 1/2, a point light of pi W/sr at its centre, the camera beside the light.
Scene litSphere() {
    Scene scene = reference::test::onePixel({0.2, 0.1, 0}, {1, 0.3, 0.2}, "photonmap");
    scene.camera.fov = 60;
    scene.camera.resolution = {16, 16};
    scene.lights.push_back({{0, 0, 0}, dvec3(pi)});
    const std::size_t diffuse = reference::test::addMaterial(scene, Diffuse{dvec3(0.5)});
    reference::test::addObject(scene, Sphere{{0, 0, 0}, 1}, diffuse);
    scene.render.maxDepth = 64;
    scene.render.photons = 100000;
    scene.render.radius = 0.25;
    return scene;
}

} // namespace

// The sphere illuminates itself uniformly: direct light gives L = 1/2, every further bounce half of the previous one, 1
// in total. About 200 000 photons land; a disc of 100 of them is accurate to 10 %, and the 16 x 16 pixels see an area
// with about 6 500 photons: 1.3 % in the mean, and less with low-discrepancy emission. Five standard deviations.
constexpr double kSphereError = 0.065;

TEST_CASE("the global map of a lit sphere shows the same radiance everywhere, by tree and grid") {
    for (const PhotonStructure structure : {PhotonStructure::Tree, PhotonStructure::Grid}) {
        Scene scene = litSphere();
        scene.render.photonMap.structure = structure;
        scene.render.photonMap.view = PhotonView::GlobalMap;
        CHECK(std::abs(meanOf(onDevice(scene).picture) - 1) < kSphereError);
    }
    Scene scene = litSphere();
    scene.render.photonMap.gatherRays = 0;
    const LayeredImage image = onDevice(scene);
    CHECK(std::abs(meanOf(layer(image, "direct")) - 0.5) < 1e-5);
    CHECK(std::abs(meanOf(layer(image, "indirect")) - 0.5) < kSphereError / 2);
}

TEST_CASE("final gathering in a lit sphere finds the light of all bounces, from records and from full estimates") {
    for (const bool precomputed : {true, false}) {
        Scene scene = litSphere();
        scene.render.passes = 4;
        scene.render.photonMap.gatherRays = 4;
        scene.render.photonMap.precomputedIrradiance = precomputed;
        const LayeredImage image = onDevice(scene);
        // 4096 rays all over the sphere, each with an estimate accurate to 10 %
        CHECK(std::abs(meanOf(layer(image, "indirect")) - 0.5) < 0.01);
        CHECK(std::abs(meanOf(image.picture) - 1) < 0.01);
    }
}

TEST_CASE("the direct photons of a floor under a point light give its irradiance, with every filter") {
    // L = albedo / pi * I h / (x^2 + z^2 + h^2)^(3/2) with I = 3, h = 2, averaged over a square of 1 m about the origin
    const int grid = 100;
    double expected = 0;
    for (int i = 0; i < grid * grid; ++i) {
        const double x = (i % grid + 0.5) / grid - 0.5;
        const int row = i / grid;
        const double z = (row + 0.5) / grid - 0.5;
        expected += 0.7 / pi * 3 * 2 / std::pow(x * x + z * z + 4, 1.5) / (grid * grid);
    }
    // The camera looks straight down, and its picture is that square: tan(fov / 2) = 0.5 / 1
    Scene scene = reference::test::onePixel({0, 1, 0}, {0, 0, 0}, "photonmap");
    scene.camera.fov = 2 * std::atan(0.5) * 180 / pi;
    scene.camera.resolution = {32, 32};
    scene.lights.push_back({{0, 2, 0}, dvec3(3)});
    const std::size_t floor = reference::test::addMaterial(scene, Diffuse{dvec3(0.7)});
    reference::test::addObject(scene, Quad{{-5, 0, 5}, {10, 0, 0}, {0, 0, -10}}, floor);
    scene.render.photons = 500000;
    scene.render.radius = 0.2;
    scene.render.photonMap.view = PhotonView::GlobalMap;
    for (const PhotonFilter filter : {PhotonFilter::None, PhotonFilter::Cone, PhotonFilter::Gaussian}) {
        scene.render.photonMap.filter = filter;
        // 9 200 photons in the square: 1 % if they were independent
        CHECK(std::abs(meanOf(onDevice(scene).picture) / expected - 1) < 0.03);
        CHECK(std::abs(meanOf(render::renderByReference(scene).picture) / expected - 1) < 0.03);
    }
}

namespace {

// A beam of irradiance 1 along -y, as wide as `width`, onto a ball of glass (n = 1.5, radius 1) above a black floor.
Scene beamThroughBall(double width, double floor) {
    Scene scene = reference::test::onePixel({0, 5, 5}, {0, 0, 0}, "photonmap");
    scene.directionals.push_back({.direction = {0, -1, 0},
                                  .irradiance = dvec3(1),
                                  .beam = DirectionalLight::Beam{.center = {0, 3, 0}, .radius = width}});
    const std::size_t glass = reference::test::addMaterial(scene, Dielectric{1.5});
    const std::size_t black = reference::test::addMaterial(scene, Diffuse{dvec3(0)});
    reference::test::addObject(scene, Sphere{{0, 0, 0}, 1}, glass);
    reference::test::addObject(scene, Quad{{-9, floor, 9}, {18, 0, 0}, {0, 0, -18}}, black);
    scene.render.maxDepth = 4; // three segments of a photon: in, out, floor; no internal reflections
    return scene;
}

// For a ray at the height h: where it crosses the axis below the centre, its angle to the axis there, and the
// transmittance of both faces.
struct Refraction {
    double focus;
    double deviation;
    double transmitted;
};

Refraction through(double h) {
    const double in = std::asin(h);
    const double out = std::asin(h / 1.5);
    const double s = std::cos(in) - 1.5 * std::cos(out);
    const double p = 1.5 * std::cos(in) - std::cos(out);
    const double rs = s / (std::cos(in) + 1.5 * std::cos(out));
    const double rp = p / (1.5 * std::cos(in) + std::cos(out));
    const double F = (rs * rs + rp * rp) / 2;
    const double deviation = 2 * (in - out); // at either face by in - out
    // The line at distance h from the centre (the ball is symmetric) meets the axis at h / sin(deviation)
    return {h / std::sin(deviation), deviation, (1 - F) * (1 - F)};
}

std::vector<shared::Photon> causticPhotons(BothSides& both, std::uint32_t count) {
    render::PhotonPaths paths(both.device, both.scene, both.deviceScene, count);
    const std::uint32_t slots = paths.trace(
        {.sequence = shared::photonSequence(shared::renderSeed(1, shared::kSobolNumbers), shared::kCausticPhotons, 0),
         .count = count,
         .kinds = 1U << shared::kPhotonCaustic,
         .aimed = true});
    both.device.commands.finish();
    return render::storedPhotons(paths.photons(), slots);
}

} // namespace

TEST_CASE("a glass ball focuses a parallel beam at its focal length, with the flux that its faces transmit") {
    // Near the axis the focus lies at n R / (2 (n - 1)) = 1.5 R from the centre
    CHECK(std::abs(through(1e-4).focus - 1.5) < 1e-6);
    const std::uint32_t count = 40000;
    for (const auto& [width, floor] : {std::pair{0.02, -1.5}, {0.5, -1.5}, {0.9, -1.5}, {0.9, -2.5}}) {
        BothSides both(beamThroughBall(width, floor));
        const std::vector<shared::Photon> photons = causticPhotons(both, count);
        double flux = 0;
        double spread = 0; // mean square distance from the axis, weighted by flux
        for (const shared::Photon& photon : photons) {
            if (photon.surface >> shared::kLengthShift != 3) {
                continue; // reflected down by the outside of the ball
            }
            flux += photon.power.x;
            spread += double{photon.power.x} *
                      (photon.position.x * photon.position.x + photon.position.z * photon.position.z);
        }
        // By rings of the beam: E 2 pi h dh of flux; at the floor (focus - |floor|) tan(deviation) off the axis
        double expectedFlux = 0;
        double expectedSpread = 0;
        const int rings = 20000;
        for (int i = 0; i < rings; ++i) {
            const double h = width * (i + 0.5) / rings;
            const Refraction r = through(h);
            const double ring = 2 * pi * h * width / rings * r.transmitted;
            const double aside = (r.focus + floor) * std::tan(r.deviation);
            expectedFlux += ring;
            expectedSpread += ring * aside * aside;
        }
        // The faces reflect 8 % by chance: 0.27 / sqrt(40 000) = 0.14 % of the flux; five times that
        CHECK(std::abs(flux / expectedFlux - 1) < 0.007);
        // At the focus of a narrow beam all light is within spherical aberration; floats place the floor to 1e-6
        CHECK(std::abs(std::sqrt(spread / flux) - std::sqrt(expectedSpread / expectedFlux)) <
              0.02 * std::sqrt(expectedSpread / expectedFlux) + 2e-6);
    }
}

} // namespace hyalite::testing
